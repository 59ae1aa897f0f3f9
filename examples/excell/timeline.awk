# A trace as a timeline in symbols, states and seconds. usage: awk [-v need=CYCLES] -f timeline.awk trace.jsonl
#
# The name LINE_PROCESS_DEVICE_DIRECTION_TASK of a symbol gives all that is needed: the PLC sets operations (O), the
# plant sets events (I), and the task is the state that is commanded or reported. A cycle is complete when every event
# has the value again that it had after time 0. Exit code 1 if there were fewer than `need` cycles.

function text_after(key,    at) { # the rest of this line after a key
  at = index($0, key)
  return at == 0 ? "" : substr($0, at + length(key))
}

function meaning(s,    d, is) {
  if (!(s in device)) return value[s] == "true" || value[s] == "false" ? "" : "= " value[s]
  d = device[s]
  is = short_of[d]
  if (value[s] != "true" && value[s] != "false") return is " " task[s] " = " value[s]
  if (operation[s]) {
    if (value[s] == "false") return is ": command " task[s] " ends"
    if (state[d] == task[s]) return is ": stays in " task[s]
    return is ": " (d in state ? state[d] " -> " : "to ") task[s]
  }
  if (value[s] == "false") return is " leaves " task[s]
  state[d] = task[s]
  return is " is in " task[s]
}

function show(s,    verb, what) {
  verb = value[s] == "true" ? "sets" : value[s] == "false" ? "clears" : "writes"
  what = meaning(s)
  printf "%8.2f s  %-5s %-6s  ", now / 1e9, operation[s] ? "PLC" : (s in device) ? "plant" : "?", verb
  if (what == "") print s
  else printf "%-" width "s  %s\n", s, what
}

function note_event(s,    was) { # keeps `moved`, the number of events that differ from their value at the start
  if (now == 0) start[s] = value[s]
  was = differs[s]
  differs[s] = (value[s] != ((s in start) ? start[s] : "false"))
  moved += differs[s] - was
}

# Within an instant the operations come first: those that go off, those that come on; then the events.
function end_instant(    i, s, part) {
  for (i = 1; i <= count; i++) value[changed[i]] = changed_to[i]
  for (part = 1; part <= 4; part++) {
    for (i = 1; i <= count; i++) {
      s = changed[i]
      if (part == (operation[s] ? 1 : 3) + (value[s] != "false")) show(s)
    }
  }
  for (i = 1; i <= count; i++) if ((changed[i] in device) && !operation[changed[i]]) note_event(changed[i])
  if (moved > 0 && !away) {
    away = 1
    left = now
  } else if (moved == 0 && away) {
    away = 0
    printf "%8.2f s  cycle %d completed, in %.2f s\n", now / 1e9, ++cycles, (now - left) / 1e9
  }
  count = 0
}

/"t":[0-9]+,"symbol":"/ {
  row_time[++rows] = text_after("\"t\":") + 0
  s = text_after("\"symbol\":\"")
  v = text_after("\"value\":")
  s = substr(s, 1, index(s, "\",\"value\":") - 1)
  sub(/[}][ \r]*$/, "", v)
  row_symbol[rows] = s
  row_value[rows] = v
  if (length(s) > width) width = length(s)
  if (s in seen) next
  seen[s] = 1
  if (split(s, level, "_") != 5 || level[4] !~ /^[IO]$/) next
  operation[s] = (level[4] == "O")
  device[s] = level[1] "_" level[2] "_" level[3]
  task[s] = level[5]
  short_of[device[s]] = level[3]
  if ((level[3] in long_of) && long_of[level[3]] != device[s]) ambiguous[level[3]] = 1
  long_of[level[3]] = device[s]
}

END {
  for (d in short_of) if (short_of[d] in ambiguous) short_of[d] = d
  for (row = 1; row <= rows; row++) {
    if (row > 1 && row_time[row] != now) end_instant()
    now = row_time[row]
    changed[++count] = row_symbol[row]
    changed_to[count] = row_value[row]
  }
  if (count > 0) end_instant()
  printf "%d cycle%s completed, %d change%s of symbols\n", cycles, cycles == 1 ? "" : "s", rows, rows == 1 ? "" : "s"
  exit cycles < need ? 1 : 0
}
