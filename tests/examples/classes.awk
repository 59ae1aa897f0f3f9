# The class of a run with a fault, from its trace and that of the base case, without the tool's code.
# usage: awk -v period=NS -v end=NS -v violated=0|1 -v lost=0|1 -v alarms="A B" -f classes.awk BASE_TRACE RUN_TRACE
# Symbols with `_I_` are read by the program, those with `_O_` written. Prints the class and, if an alarm comes on, the
# milliseconds from the first scan that reads something else. An alarm counts that comes on once more than in the base case,
# or earlier.
FNR == 1 { ++file }
!/"symbol":/ { next }
{
  time = symbol = value = $0
  sub(/^{"t":/, "", time); sub(/,.*/, "", time)
  sub(/.*"symbol":"/, "", symbol); sub(/".*/, "", symbol)
  sub(/.*"value":/, "", value); sub(/}.*/, "", value)
  is_operation = symbol ~ /_O_/
  if (is_operation) {
    changes[file] = changes[file] time " " symbol " " value "\n"
    pause = time - last[file]
    if (pause > longest[file]) longest[file] = pause
    last[file] = time
    if (value == "true" && index(" " alarms " ", " " symbol " ")) rise[file, symbol, ++rises[file, symbol]] = time
  } else {
    scan = int((time + period - 1) / period)
    read[file, symbol, scan] = value
    symbols[symbol]
    if (scan > scans) scans = scan
  }
}
END {
  seen = -1
  for (scan = 0; scan <= scans && seen < 0; ++scan) {
    for (symbol in symbols) {
      for (f = 1; f <= 2; ++f) if ((f, symbol, scan) in read) now[f, symbol] = read[f, symbol, scan]
      if (now[1, symbol] "" != now[2, symbol] "" && !(now[1, symbol] != "true" && now[2, symbol] != "true")) seen = scan * period
    }
  }
  if (lost) seen = 0
  if (end - last[1] > longest[1]) longest[1] = end - last[1]
  alarm = ""
  n = split(alarms, names, " ")
  for (i = 1; i <= n; ++i) {
    for (k = 1; k <= rises[2, names[i]]; ++k) {
      time = rise[2, names[i], k]
      if (k <= rises[1, names[i]] && time + 0 >= rise[1, names[i], k] + 0) continue
      if (alarm == "" || time + 0 < alarm + 0) alarm = time
    }
  }
  class = "other"
  if (end - last[2] > longest[1]) class = "stopped"
  if (changes[1] == changes[2]) class = "undetected"
  if (alarm != "") class = "detected"
  if (seen < 0) class = "no effect"
  if (violated) class = "violated"
  printf "%s %s\n", class, alarm == "" ? "-" : int((alarm - seen) / 1000000 + 0.5)
}
