# Writes the symbol list of the body-shop line, which is committed. usage: awk -f list.awk /dev/null >body-shop.csv
#
# One PLC, one line, 40 stations. Each station uses whole modules of 32 points: its addresses begin at X..00, 20, 40 ...
# and some points stay free. X and Y count in hexadecimal: X0010 is %IX16. Words begin after the bits, at %IW256, and
# have no MELSEC address.

# The symbols of each device shape: direction, task, then T for Initial TRUE or the type of a number, then the comment.
# `said` has the words for a device in comments, if its name is not descriptive.
function shapes() {
  shape["ROBOT"] = "O HOME1 . go home|O JOB2 . begin the job|I HOME1 T is at home|I JOB2 . works|I DONE3 . work complete" \
    "|O PROG WORD program to run|I PROG WORD program that runs"
  shape["WELDER"] = "O ON . power on|I ON . power is on|O SCHEDULE WORD weld schedule|I CURRENT INT kA/100 of the last spot" \
    "|I SPOTS WORD spots since the last dressing"
  shape["DRESSER"] = "O RUN2 . dress the caps|I IDLE1 T is idle|I RUN2 . is dressing"
  shape["GRIPPER"] = "O OPEN . open|O GRIP . grip|I OPEN T is open|I GRIP . has gripped"
  shape["CLAMP"] = "O OPEN . open|O CLOSE . close|I OPEN T is open|I CLOSE . is closed"
  shape["LATCH"] = "O LOCK . lock, spring return|I LOCK . is locked|I FREE T is free"
  shape["PIN"] = "O UP . raise|O DOWN . lower|I UP . is up|I DOWN T is down"
  shape["TABLE"] = "O POS1 . turn to side 1|O POS2 . turn to side 2|I POS1 T side 1 faces the robots|I POS2 . side 2 faces the robots"
  shape["DRUM"] = "O POS1 . turn to gate 1|O POS2 . turn to gate 2|O POS3 . turn to gate 3|O POS4 . turn to gate 4" \
    "|I POS1 T gate 1 is in place|I POS2 . gate 2 is in place|I POS3 . gate 3 is in place|I POS4 . gate 4 is in place"
  shape["SHUTTLE"] = "O BACK1 . go back|O MID2 . go to the middle|O FRONT3 . go to the front|I BACK1 T is at the back" \
    "|I MID2 . is in the middle|I FRONT3 . is at the front"
  shape["CONVEYOR"] = "O ENTRY1 . take the skid over|O STOP2 . run the skid to the stop|O EXIT3 . hand the skid on|I ENTRY1 T skid at the entry" \
    "|I STOP2 . skid at the stop|I EXIT3 . skid at the exit"
  shape["LIFTER"] = "O LOW1 . lower|O HIGH2 . raise|I LOW1 T is low|I HIGH2 . is high"
  shape["DRIVE"] = "O RUN . contactor|I RUN . contactor is in"
  shape["PUMP"] = shape["DRIVE"]
  shape["SEALER"] = "O ON . apply|I ON . applies|O FLOW INT ml/min wanted|I PRESSURE INT bar/10"
  shape["CAMERA"] = "O TAKE2 . take and judge a picture|I READY1 T is ready|I TAKE2 . is at work|I RESULT WORD verdict of the last picture"
  shape["GAUGE"] = "I GAP1 INT um at the front left|I GAP2 INT um at the front right|I GAP3 INT um at the rear left|I GAP4 INT um at the rear right"
  shape["VARIANT"] = "O CODE WORD wanted|I CODE WORD read from the skid"
  shape["CYCLE"] = "I TIME INT s/10 that the last one took"
  shape["SELECTOR"] = "I AUTO T is on automatic|I MANUAL . is on manual"
  shape["ESTOP"] = "I SAFE T is not pressed"
  shape["DOOR"] = "I SHUT T is shut"
  shape["CURTAIN"] = "I CLEAR T is clear"
  shape["AIR"] = "I GOOD T is good"
  shape["PART"] = "I SEEN . is present"
  shape["BUTTONSTART"] = shape["BUTTONHALT"] = shape["BUTTONRESET"] = "I PUSH . is pushed"
  shape["LIGHTRED"] = shape["LIGHTAMBER"] = shape["LIGHTGREEN"] = shape["HORN"] = "O ON . on"
  said["SELECTOR"] = "mode selector"
  said["AIR"] = "air pressure"
  said["ESTOP"] = "emergency stop"
  said["CURTAIN"] = "light curtain"
  said["DOOR"] = "safety door"
  said["VARIANT"] = "body variant"
  said["WELDER"] = "weld control"
  said["DRESSER"] = "cap dresser"
  said["BUTTONSTART"] = "start button"
  said["BUTTONHALT"] = "halt button"
  said["BUTTONRESET"] = "reset button"
  said["LIGHTRED"] = "red light"
  said["LIGHTAMBER"] = "amber light"
  said["LIGHTGREEN"] = "green light"
}

# The kinds of station: their numbers, and the devices of each.
function kinds() {
  common = "SELECTOR AIR ESTOP2 DOOR2 CURTAIN BUTTONSTART BUTTONHALT BUTTONRESET LIGHTRED LIGHTAMBER LIGHTGREEN HORN VARIANT CYCLE"
  kind("UNDER", 10, "underbody", "PART2 PIN2 CLAMP4 LATCH1 GRIPPER1 ROBOT2 WELDER2 DRESSER1")
  kind("SIDE", 6, "body side", "PART2 PIN2 CLAMP4 LATCH2 TABLE1 ROBOT2 WELDER2 DRESSER1")
  kind("FRAME", 4, "framing", "PART2 PIN2 CLAMP4 DRUM1 LIFTER1 ROBOT4 WELDER4 DRESSER2")
  kind("SPOT", 8, "respot", "PART1 PIN2 ROBOT4 WELDER4 DRESSER2")
  kind("ROOF", 3, "roof", "PART2 PIN2 CLAMP4 LIFTER1 GRIPPER1 ROBOT2 SEALER1")
  kind("SEAL", 3, "sealing", "PART1 PIN2 PUMP1 ROBOT2 SEALER2")
  kind("INSP", 2, "inspection", "PART1 PIN2 ROBOT2 CAMERA2 GAUGE1")
  kind("MOVE", 4, "transfer", "PART2 SHUTTLE1 CONVEYOR1 LIFTER1 DRIVE2 LATCH2")
}

# The first point of the next unused module of 32 points, where the next station begins.
function next_module(place) { return int((place + 31) / 32) * 32 }

# A number after a device is the count of such devices. Without a number there is one device, and its name has no number.
function station(name, words, devices,    list, count, i, n, all) {
  input = next_module(input)
  output = next_module(output)
  count = split(devices, list, " ")
  for (i = 1; i <= count; i++) {
    all = list[i]
    sub(/[A-Z]+/, "", all)
    sub(/[0-9]+$/, "", list[i])
    if (all == "") device(name, list[i], "", words)
    else for (n = 1; n <= all + 0; n++) device(name, list[i], n, words)
  }
}

function device(place, base, number, words,    rows, count, i, part, comment) {
  if (!(base in shape)) {
    printf "list.awk: no shape %s\n", base | "cat >&2"
    exit 1
  }
  count = split(shape[base], rows, "|")
  for (i = 1; i <= count; i++) {
    split(rows[i], part, " ")
    comment = (base in said ? said[base] : tolower(base)) (number == "" ? "" : " " number)
    comment = words ": " comment " " substr(rows[i], length(part[1] part[2] part[3]) + 4)
    row("BODY_" place "_" base number "_" part[1] "_" part[2], part[1] == "I", part[3], comment)
  }
}

function row(name, is_input, about, comment,    number) {
  if (length(about) > 1) { # the type of a number
    number = is_input ? input_word++ : output_word++
    printf "VAR_GLOBAL,%s,,%%%sW%d,%s,0,%s\n", name, is_input ? "I" : "Q", number, about, comment
    return
  }
  number = is_input ? input++ : output++
  printf "VAR_GLOBAL,%s,%s%04X,%%%sX%d,BOOL,%s,%s\n", name, is_input ? "X" : "Y", number, is_input ? "I" : "Q", number,
         about == "T" ? "TRUE" : "FALSE", comment
}

function kind(process, many, words, devices,    i) {
  for (i = 1; i <= many; i++) station(process i * 10, words " " i * 10, common " " devices)
}

BEGIN {
  input_word = output_word = 256
  shapes()
  printf "Class,Identifier,MIT-Addr.,IEC-Addr.,Type,Initial,Comment\n"
  kinds()
}
