# Writes the description of the body-shop line from its list. usage: awk -f plant.awk body-shop.csv >plant.json
#
# Times are given for patterns. Interlocks and requirements name the devices of one station: they are written station by station.
# The bodies travel on four tracks, one for each shuttle.

BEGIN { FS = "," }

$2 ~ /^BODY_/ {
  split($2, level, "_")
  if (!(level[2] in seen)) station[++stations] = level[2]
  seen[level[2]] = 1
  if ((level[2], level[3]) in known) next
  known[level[2], level[3]] = 1
  shape = level[3]
  sub(/[0-9]+$/, "", shape)
  number = ++many[level[2], shape]
  device[level[2], shape, number] = "BODY_" level[2] "_" level[3]
}

END {
  print "{"
  print "  // The body-shop line. Generated from its list by plant.awk: edit that script, not this file."
  print "  \"symplant\": 1,"
  print "  \"name\": \"body-shop\","
  print "  \"symbols\": [\"body-shop.csv\"],"
  print "  \"devices\": {"
  times()
  for (s = 1; s <= stations; s++) interlocks(station[s])
  print "\n  },"
  follow()
  values()
  material()
  print "  // What the program reports a fault with.\n  \"alarms\": [\"BODY_*_HORN_O_ON\", \"BODY_*_LIGHTRED_O_ON\"],"
  print "  \"requirements\": ["
  separator = ""
  for (s = 1; s <= stations; s++) requirements(station[s])
  print "\n  ]"
  print "}"
}

# Travel times, shape by shape.
function times() {
  double_acting("PIN", "DOWN", "UP", "0.8s", "0.6s")
  double_acting("CLAMP", "OPEN", "CLOSE", "0.6s", "0.6s")
  double_acting("GRIPPER", "OPEN", "GRIP", "0.4s", "0.3s")
  entry("BODY_*_LATCH?", "\"transitions\": [ " way("FREE", "LOCK", "0.4s") ", " way("LOCK", "FREE", "0.5s") " ]")
  entry("BODY_*_TABLE?", "\"transitions\": [ " way("*", "POS1", "6s") ", " way("*", "POS2", "6s") " ]")
  entry("BODY_*_DRUM?", "\"transitions\": [ " way("*", "POS1", "9s") ", " way("*", "POS2", "9s") ", " way("*", "POS3", "9s") ", " \
        way("*", "POS4", "9s") " ]")
  entry("BODY_*_SHUTTLE?", "\"actuation\": \"held\", \"transitions\": [ " way("BACK1", "FRONT3", "7s") ", " way("FRONT3", "BACK1", "7s") \
        ", " way("*", "MID2", "3.5s") ", " way("MID2", "BACK1", "3.5s") ", " way("MID2", "FRONT3", "3.5s") " ]")
  entry("BODY_*_CONVEYOR?", "\"actuation\": \"held\", \"only\": true, \"transitions\": [ " way("ENTRY1", "STOP2", "5s") ", " \
        way("STOP2", "EXIT3", "5s") ", " way("EXIT3", "ENTRY1", "8s") " ]")
  entry("BODY_*_LIFTER?", "\"actuation\": \"held\", \"transitions\": [ " way("LOW1", "HIGH2", "4.5s") ", " way("HIGH2", "LOW1", "4s") " ]")
  entry("BODY_*_DRIVE?", "\"transitions\": [ " way("NOT_RUN", "RUN", "50ms") ", " way("RUN", "NOT_RUN", "30ms") " ]")
  entry("BODY_*_PUMP?", "\"transitions\": [ " way("NOT_RUN", "RUN", "2s") ", " way("RUN", "NOT_RUN", "1s") " ]")
  entry("BODY_*_WELDER?", "\"transitions\": [ " way("NOT_ON", "ON", "0.2s") ", " way("ON", "NOT_ON", "0.1s") " ]")
  entry("BODY_*_SEALER?", "\"transitions\": [ " way("NOT_ON", "ON", "0.1s") ", " way("ON", "NOT_ON", "0.1s") " ]")
  entry("BODY_*_DRESSER?", "\"transitions\": [ " way("IDLE1", "RUN2", "0.1s") ", " by_itself("RUN2", "IDLE1", "\"8s\"") " ]")
  entry("BODY_*_CAMERA?", "\"transitions\": [ " way("READY1", "TAKE2", "20ms") ", " by_itself("TAKE2", "READY1", "\"0.35s\"") " ]")
}

function double_acting(shape, rest, work, there, back) {
  entry("BODY_*_" shape "?", "\"actuation\": \"bistable\", \"transitions\": [ " way(rest, work, there) ", " way(work, rest, back) " ]")
}

# Hard-wired interlocks, which no program contains: what disables a device, and what a robot waits for.
function interlocks(place,    air, power) {
  separator = ",\n\n    // " place "\n"
  air = those(place, "CLAMP PIN LATCH GRIPPER")
  power = those(place, "ROBOT TABLE DRUM SHUTTLE CONVEYOR LIFTER DRIVE")
  entry(name(place, "ESTOP?"), "\"disables\": { \"NOT_SAFE\": [" power "] }")
  entry(name(place, "DOOR?"), "\"disables\": { \"NOT_SHUT\": [" power "] }")
  entry(name(place, "CURTAIN"), "\"disables\": { \"NOT_CLEAR\": [" power "] }")
  if (air != "") entry(name(place, "AIR"), "\"disables\": { \"NOT_GOOD\": [" air "] }")
  robots(place)
  if (has(place, "TABLE")) {
    entry(name(place, "TABLE1"), "\"transitions\": [ " way("*", "POS1", "6s", every(place, "LATCH", "FREE", "and")) ", " \
          way("*", "POS2", "6s", every(place, "LATCH", "FREE", "and")) " ]")
  }
}

# A robot begins when its welder or pump is on, or with air, and works for the duration of its job.
function robots(place,    i, when) {
  for (i = 1; i <= has(place, "ROBOT"); i++) {
    when = name(place, "AIR") ".GOOD"
    if (has(place, "WELDER")) when = device[place, "WELDER", i] ".ON"
    if (has(place, "PUMP")) when = device[place, "PUMP", 1] ".RUN"
    entry(device[place, "ROBOT", i], "\"only\": true, \"transitions\": [ " way("HOME1", "JOB2", "0.3s", when) ", " \
          by_itself("JOB2", "DONE3", job_of(place, i)) ", " way("DONE3", "HOME1", i % 2 ? "2.5s" : "3s") " ]")
  }
}

function job_of(place, robot) {
  if (place ~ /^UNDER/) return robot == 1 ? "\"18s\"" : "\"20.5s\""
  if (place ~ /^SIDE/) return "\"16.5s\""
  if (place ~ /^FRAME/) return "\"32s\""
  if (place ~ /^SPOT/) return "{ \"min\": \"27s\", \"max\": \"31s\" }"
  if (place ~ /^ROOF/) return "\"21s\""
  if (place ~ /^SEAL/) return "{ \"mean\": \"38s\", \"sigma\": \"0.5s\" }"
  return "\"12s\""
}

# Requirements on the program.
function requirements(place,    robots_work, robots_home, i) {
  robots_work = every(place, "ROBOT", "JOB2", "or")
  robots_home = every(place, "ROBOT", "HOME1", "and")
  if (has(place, "CLAMP")) {
    for (i = 1; i <= has(place, "ROBOT"); i++) {
      never(place ": robot " i " works only in closed clamps",
            device[place, "ROBOT", i] ".JOB2 and not (" every(place, "CLAMP", "CLOSE", "and") ")")
    }
    never(place ": clamps close on raised pins only",
          "(" every(place, "CLAMP", "CLOSE", "or") ") and not (" every(place, "PIN", "UP", "and") ")")
  } else if (has(place, "PIN")) {
    never(place ": robots work on raised pins only", "(" robots_work ") and not (" every(place, "PIN", "UP", "and") ")")
  }
  if (has(place, "TABLE")) {
    never(place ": the table turns only with the robots at home", device[place, "TABLE", 1] ".moving and not (" robots_home ")")
    never(place ": the table turns only with closed clamps",
          device[place, "TABLE", 1] ".moving and not (" every(place, "CLAMP", "CLOSE", "and") ")")
  }
  if (has(place, "DRUM")) {
    never(place ": the drum turns only with the robots at home", device[place, "DRUM", 1] ".moving and not (" robots_home ")")
    never(place ": the drum turns only over open clamps",
          device[place, "DRUM", 1] ".moving and not (" every(place, "CLAMP", "OPEN", "and") ")")
  }
  if (has(place, "SHUTTLE")) {
    never(place ": the shuttle moves only under a low lifter", device[place, "SHUTTLE", 1] ".moving and not " device[place, "LIFTER", 1] ".LOW1")
    never(place ": the shuttle moves only with free latches",
          device[place, "SHUTTLE", 1] ".moving and not (" every(place, "LATCH", "FREE", "and") ")")
  }
  if (has(place, "PIN")) {
    never(place ": the shuttle comes only over lowered pins",
          shuttle_of(place) ".moving and not (" every(place, "PIN", "DOWN", "and") ")")
  }
  for (i = 1; i <= has(place, "ROBOT"); i++) {
    after(place ": robot " i " is sent home when it is done", device[place, "ROBOT", i] ".DONE3", device[place, "ROBOT", i] ".HOME1", "10s")
  }
  after(place ": the light is red within half a second of an emergency stop", "not (" every(place, "ESTOP", "SAFE", "and") ")",
        name(place, "LIGHTRED_O_ON"), "500ms")
}

# The transfer station whose shuttle carries the bodies into a station.
function transfer_of(place) {
  if (place ~ /^MOVE/) return place
  if (place ~ /^UNDER/) return "MOVE10"
  if (place ~ /^(SIDE|FRAME)/) return "MOVE20"
  if (place ~ /^SPOT/) return "MOVE30"
  return "MOVE40"
}

function shuttle_of(place) { return name(transfer_of(place), "SHUTTLE1") }

function follow() {
  print "  // A mode selector has two contacts: when one is closed, the other is open."
  print "  \"follow\": { \"BODY_*_SELECTOR_I_MANUAL\": \"not BODY_{1}_SELECTOR_I_AUTO\" },"
}

# What the numeric inputs show.
function values() {
  print "  \"values\": {"
  print "    // A robot reports its program from the beginning of the job until it is at home."
  value("{self}.program", "BODY_*_ROBOT?", "\"changes\": [ " change("{self}.JOB2", "{self}_O_PROG") ", " change("{self}.HOME1", "0") " ]")
  print "    // A spot takes 0.4 s. Each has a current; the counter is reset when the caps are dressed."
  value("{self}.welded", "BODY_*_WELDER?", "\"step\": \"100ms\", \"trace\": false, \"integral\": \"2.5 * {self}.ON * BODY_{1}_ROBOT{2}.JOB2\",\n      " \
        "\"changes\": [ " change("{self}.ON and BODY_{1}_DRESSER1.RUN2", "0") " ]")
  value("{self}.spot", "BODY_*_WELDER?", "\"step\": \"100ms\", \"trace\": false, \"is\": \"wrap({self}.welded, 0, 1)\"")
  value("{self}.scatter", "BODY_*_WELDER?", "\"trace\": false, \"noise\": 12, \"every\": \"400ms\"")
  value("{self}.current", "BODY_*_WELDER?", "\"unit\": \"kA/100\", \"changes\": [ " change("{self}.spot < 0.5 and {self}.welded >= 1", "870 + {self}.scatter") " ]")
  print "    // A camera finds about one bad body of twenty."
  value("{self}.luck", "BODY_*_CAMERA?", "\"trace\": false, \"noise\": 1, \"every\": \"1s\"")
  value("{self}.verdict", "BODY_*_CAMERA?", "\"changes\": [ " change("{self}.TAKE2", "if({self}.luck > 1.645, 2, 1)") " ]")
  print "    // A cycle lasts from job to job of the first robot, or from stroke to stroke of a shuttle."
  value("BODY_{1}_CYCLE.began", "BODY_*_ROBOT1", "\"unit\": \"s\", \"trace\": false, \"changes\": [ " change("{self}.JOB2", "time") " ]")
  value("BODY_{1}_CYCLE.lasted", "BODY_*_ROBOT1", "\"unit\": \"s\", \"changes\": [ " change("{self}.JOB2", "time - BODY_{1}_CYCLE.began") " ]")
  value("{line}_{1}_CYCLE.began", "BODY_*_SHUTTLE1", "\"unit\": \"s\", \"trace\": false, \"changes\": [ " change("{self}.FRONT3", "time") " ]")
  value("{line}_{1}_CYCLE.lasted", "BODY_*_SHUTTLE1", "\"unit\": \"s\", \"changes\": [ " change("{self}.FRONT3", "time - {line}_{1}_CYCLE.began") " ]", 1)
  print "  },"
  print "  \"signals\": {"
  print "    \"BODY_*_ROBOT?_I_PROG\": \"BODY_{1}_ROBOT{2}.program\","
  print "    \"BODY_*_WELDER?_I_SPOTS\": \"floor(BODY_{1}_WELDER{2}.welded)\","
  print "    \"BODY_*_WELDER?_I_CURRENT\": \"BODY_{1}_WELDER{2}.current\","
  print "    \"BODY_*_SEALER?_I_PRESSURE\": \"BODY_{1}_SEALER{2}.ON * limit(BODY_{1}_SEALER{2}_O_FLOW, 0, 2500)\","
  print "    \"BODY_*_CAMERA?_I_RESULT\": \"BODY_{1}_CAMERA{2}.verdict\","
  print "    \"BODY_*_GAUGE?_I_GAP?\": { \"of\": \"3500\", \"noise\": 40, \"every\": \"10s\" },"
  print "    \"BODY_*_CYCLE_I_TIME\": \"10 * BODY_{1}_CYCLE.lasted\""
  print "  },"
}

function value(number, devices, what, last) { printf "    \"%s\": { \"for\": \"%s\", %s }%s\n", number, devices, what, last ? "" : "," }

function change(when, to) { return "{ \"when\": \"" when "\", \"to\": \"" to "\" }" }

# The floors of two models come in at UNDER10 and become bodies in the last framing station.
function material() {
  print "\n  // Bodies are 4.5 m long and stop every 7 m. A stroke of the shuttle carries each body of its track one station on, the last one"
  print "  // to the conveyor of the transfer, which hands it to the next track."
  print "  \"material\": {"
  print "    \"kinds\": {"
  print "      \"sedan_floor\": { \"length\": \"4500 mm\", \"code\": 3 }, \"sedan\": { \"length\": \"4500 mm\", \"code\": 3 },"
  print "      \"estate_floor\": { \"length\": \"4500 mm\", \"code\": 5 }, \"estate\": { \"length\": \"4500 mm\", \"code\": 5 }"
  print "    },"
  print "    \"tracks\": {"
  track("UNDERBODY", "MOVE10", "", "FRAMING")
  track("FRAMING", "MOVE20", "MOVE10", "RESPOT")
  track("RESPOT", "MOVE30", "MOVE20", "FINISH")
  track("FINISH", "MOVE40", "MOVE30", "out")
  print "    },"
  print "    \"work\": ["
  print "      { \"name\": \"frame sedan\", \"at\": \"FRAMING@66.75 m\", \"when\": \"BODY_FRAME40_ROBOT1.DONE3\", \"from\": \"sedan_floor\", \"to\": \"sedan\" },"
  print "      { \"name\": \"frame estate\", \"at\": \"FRAMING@66.75 m\", \"when\": \"BODY_FRAME40_ROBOT1.DONE3\", \"from\": \"estate_floor\", \"to\": \"estate\" }"
  print "    ],"
  print "    \"sources\": ["
  print "      // The operator puts a floor on lowered pins while the shuttle is back."
  print "      { \"name\": \"floors\", \"at\": \"UNDERBODY@3.75 m\", \"kind\": [\"sedan_floor\", \"estate_floor\"], \"first\": \"0.5s\", \"every\": \"20s\","
  print "        \"when\": \"" name("MOVE10", "SHUTTLE1") ".BACK1 and " every("UNDER10", "PIN", "DOWN", "and") "\" },"
  print "      { \"name\": \"left in SIDE10\", \"at\": \"FRAMING@3.75 m\", \"kind\": \"sedan_floor\" }"
  print "    ]"
  print "  },\n"
}

# A track with the stations of one transfer, in the order of the list. Body k ends 1 m before 7k m; its middle is where the next drive begins.
function track(track_name, transfer, before, next_track,    s, k, stops, sensors) {
  for (s = 1; s <= stations; s++) {
    if (transfer_of(station[s]) != transfer || station[s] == transfer) continue
    k++
    stops = stops (k == 1 ? "" : ",") "\n          { \"at\": \"" 7 * k - 1 " m\", \"when\": \"" every(station[s], "PIN", "UP", "or") "\" }"
    sensors = sensors (k == 1 ? "" : ",") sensors_of(station[s], 7 * k - 1)
  }
  sensors = sensors "," sensors_of(transfer, 7 * k + 6)
  printf "%s      \"%s\": {\n        \"length\": \"%d m\", \"drives\": [", track_name == "UNDERBODY" ? "" : ",\n", track_name, 7 * k + 13
  if (before != "") printf "\n          { \"until\": \"3750 mm\", \"forward\": \"%s.RUN\", \"speed\": \"1 m/s\" },", name(before, "DRIVE2")
  printf "\n          { \"until\": \"%d mm\", \"forward\": \"%s.moving and %s_O_FRONT3\", \"speed\": \"1 m/s\" },",
         7000 * k + 3750, name(transfer, "SHUTTLE1"), name(transfer, "SHUTTLE1")
  printf "\n          { \"forward\": \"%s.RUN\", \"speed\": \"1 m/s\" } ],", name(transfer, "DRIVE1")
  printf "\n        \"stops\": [%s ],\n        \"sensors\": [%s ],\n        \"end\": \"%s\"\n      }%s", stops, sensors, next_track, next_track == "out" ? "\n" : ""
}

# The sensors of a body whose front is at a position: part 1 near its front, part 2 near its rear, the reader of the skid in the middle.
function sensors_of(place, front,    text) {
  text = sensor(name(place, "PART1_I_SEEN"), front * 1000 - 200)
  if (has(place, "PART") > 1) text = text "," sensor(name(place, "PART2_I_SEEN"), front * 1000 - 4300)
  return text "," sensor(name(place, "VARIANT_I_CODE"), front * 1000 - 2250, ", \"reads\": \"code\"")
}

function sensor(symbol, at, more) { return "\n          { \"symbol\": \"" symbol "\", \"at\": \"" at " mm\"" more " }" }

function name(place, what) { return "BODY_" place "_" what }

function has(place, shape) { return many[place, shape] + 0 }

# A condition on all devices of a shape in a station.
function every(place, shape, state, word,    i, text) {
  for (i = 1; i <= has(place, shape); i++) text = text (i == 1 ? "" : " " word " ") device[place, shape, i] "." state
  return text
}

# Patterns of those shapes that a station has.
function those(place, shapes,    list, count, i, text) {
  count = split(shapes, list, " ")
  for (i = 1; i <= count; i++) if (has(place, list[i])) text = text (text == "" ? "" : ", ") "\"" name(place, list[i] "?") "\""
  return text
}

function way(from, to, takes, when) {
  return "{ \"from\": \"" from "\", \"to\": \"" to "\", \"takes\": \"" takes "\"" (when == "" ? "" : ", \"when\": \"" when "\"") " }"
}

function by_itself(from, to, duration) {
  return "{ \"from\": \"" from "\", \"to\": \"" to "\", \"automatic\": true, \"after\": " duration " }"
}

function entry(who, what) {
  printf "%s    \"%s\": { %s }", separator, who, what
  separator = ",\n"
}

function never(what, condition) {
  printf "%s    { \"name\": \"%s\",\n      \"never\": \"%s\" }", separator, what, condition
  separator = ",\n"
}

function after(what, condition, expected, within) {
  printf "%s    { \"name\": \"%s\",\n      \"after\": \"%s\", \"expect\": \"%s\", \"within\": \"%s\" }", separator, what, condition, expected, within
  separator = ",\n"
}
