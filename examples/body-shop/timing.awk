# Draws a trace as a timing chart in SVG: for each device, the commands of the PLC and the reported state.
#
# usage: awk -v devices="DEVICE DEVICE ..." -v until=SECONDS -v title=TEXT [-v mark=SECONDS -v note=TEXT] -f timing.awk \
#   trace.jsonl >chart.svg
#
# A device is LINE_PROCESS_DEVICE. The blue bars are its operations. Below them is the state whose event is on: dark, unless
# it is the initial state. If a device has more than one event and none is on, it is moving.

function text_after(key,    at) { # the rest of this line after a key
  at = index($0, key)
  return at == 0 ? "" : substr($0, at + length(key))
}

BEGIN {
  lanes = split(devices, lane, " ")
  for (i = 1; i <= lanes; i++) place[lane[i]] = i
}

/"symbol":/ {
  name = text_after("\"symbol\":\"")
  sub(/".*/, "", name)
  if (split(name, level, "_") != 5) next
  d = place[level[1] "_" level[2] "_" level[3]]
  value = text_after("\"value\":")
  sub(/}.*/, "", value)
  if (!d || (value != "true" && value != "false")) next
  now = text_after("\"t\":") / 1e9
  if (level[4] == "O") operation(d, level[5], value == "true")
  else event(d, level[5], value == "true")
}

function operation(d, task, on,    o) {
  if (on) began[d, task] = now
  else {
    o = ++operations[d]
    task_of[d, o] = task
    from_of[d, o] = began[d, task]
    to_of[d, o] = now
    delete began[d, task]
  }
}

function event(d, task, on) {
  if (!((d, task) in seen)) {
    seen[d, task] = 1
    events[d]++
  }
  close_segment(d)
  if (on) state[d] = task
  else if (state[d] == task) state[d] = ""
  if (now == 0 && on) first[d] = task
}

function close_segment(d,    s) {
  if (now > since[d]) {
    s = ++segments[d]
    name_of[d, s] = state[d]
    begin_of[d, s] = since[d] + 0
    end_of[d, s] = now
  }
  since[d] = now
}

END {
  for (key in began) {
    split(key, part, SUBSEP)
    pending[++open] = key
  }
  sort(pending, open)
  now = until
  for (i = 1; i <= open; i++) {
    split(pending[i], part, SUBSEP)
    operation(part[1], part[2], 0)
  }
  for (d = 1; d <= lanes; d++) close_segment(d)
  left = 128
  right = 984
  top = 74
  height = 41
  draw()
}

function sort(list, count,    i, j, text) { # insertion sort, for short lists
  for (i = 2; i <= count; i++) {
    text = list[i]
    for (j = i - 1; j >= 1 && list[j] > text; j--) list[j + 1] = list[j]
    list[j + 1] = text
  }
}

function x(t) { return left + (t > until ? until : t) * (right - left) / until }

function draw(    d, bottom) {
  bottom = top + groups_above(lanes) * 8 + lanes * height
  head(bottom, bottom + (note == "" ? 12 : 28))
  for (d = 1; d <= lanes; d++) draw_lane(d, top + groups_above(d) * 8 + (d - 1) * height)
  if (note != "") {
    printf "<path d=\"M%.1f %dV%d\" stroke=\"#c62828\" stroke-width=\"2\"/>\n", x(mark), top - 6, bottom + 6
    words(x(mark), bottom + 19, "#c62828", "font-weight=\"bold\" text-anchor=\"" (mark > until / 2 ? "end" : "start") "\"", note)
  }
  print "</svg>"
}

# The number of stations that begin above a lane or with it, the first one not counted.
function groups_above(d,    i, count) {
  for (i = 2; i <= d; i++) count += station(i) != station(i - 1)
  return count + 0
}

function station(d,    part) {
  split(lane[d], part, "_")
  return part[2]
}

function head(bottom, end,    t) {
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 %d\" width=\"1000\" height=\"%d\"", end, end
  print " font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">"
  print "<defs><pattern id=\"moving\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
  print "<rect width=\"6\" height=\"6\" fill=\"#fdebc8\"/><rect width=\"2.5\" height=\"6\" fill=\"#e8a33d\"/></pattern></defs>"
  printf "<rect width=\"1000\" height=\"%d\" fill=\"#ffffff\"/>\n", end
  words(16, 24, "#1b2733", "font-size=\"16\" font-weight=\"bold\"", title)
  legend()
  for (t = 0; t <= until; t++) {
    printf "<path d=\"M%.1f %dV%d\" stroke=\"%s\"/>\n", x(t), top - 6, bottom, t % 5 ? "#f0f2f5" : "#cfd6de"
    if (t % 5 == 0) words(x(t), top - 11, "#5b6875", "font-size=\"11\" text-anchor=\"middle\"", t " s")
  }
}

function legend() {
  print "<rect x=\"16\" y=\"36\" width=\"26\" height=\"9\" rx=\"2\" fill=\"#2563c9\"/>"
  words(47, 45, "#3a4652", "", "the PLC's operation is on")
  box(212, 242, 34, 13, "#e6eaee", "#c3ccd5")
  words(247, 45, "#3a4652", "", "initial state")
  box(348, 378, 34, 13, "#0e7c66", "#0b6353")
  words(383, 45, "#3a4652", "", "another state, its event is on")
  box(566, 596, 34, 13, "url(#moving)", "#e8a33d")
  words(601, 45, "#3a4652", "", "moving, no event is on")
}

function draw_lane(d, y,    part, s, o) {
  split(lane[d], part, "_")
  if (d == 1 || station(d) != station(d - 1)) {
    printf "<path d=\"M16 %dH%d\" stroke=\"#8b98a5\"/>\n", y - 2, right
    words(16, y + 12, "#8b98a5", "font-size=\"11\"", part[2])
  }
  words(118, y + 32, "#1b2733", "text-anchor=\"end\" font-weight=\"bold\"", part[3])
  for (s = 1; s <= segments[d]; s++) draw_state(d, name_of[d, s], begin_of[d, s], end_of[d, s], y)
  for (o = 1; o <= operations[d]; o++) draw_operation(task_of[d, o], from_of[d, o], to_of[d, o], y)
}

function draw_state(d, name, from, to, y,    dark, width) {
  if (from >= until) return
  width = x(to) - x(from)
  if (name == "" && events[d] > 1) {
    box(x(from), x(to), y + 19, 17, "url(#moving)", "#e8a33d")
    return
  }
  dark = name != "" && name != first[d]
  box(x(from), x(to), y + 19, 17, dark ? "#0e7c66" : "#e6eaee", dark ? "#0b6353" : "#c3ccd5")
  if (width > 8 * length(name) + 6 && name != "") {
    words(x(from) + width / 2, y + 32, dark ? "#ffffff" : "#5b6875", "font-size=\"11\" text-anchor=\"middle\"", name)
  }
}

function draw_operation(task, from, to, y,    width) {
  if (from >= until) return
  width = x(to) - x(from)
  printf "<rect x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"11\" rx=\"2\" fill=\"#2563c9\"/>\n", x(from), y + 4, width < 2 ? 2 : width
  if (width > 8 * length(task) + 6) words(x(from) + width / 2, y + 13, "#ffffff", "font-size=\"10\" text-anchor=\"middle\"", task)
  else words(x(to) + 4, y + 13, "#2563c9", "font-size=\"10\"", task)
}

function box(from, to, y, high, fill, edge) {
  printf "<rect x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"%d\" rx=\"2\" fill=\"%s\" stroke=\"%s\"/>\n", from, y, to - from, high, fill, edge
}

function words(at, y, colour, how, text) {
  gsub(/&/, "\\&amp;", text)
  gsub(/</, "\\&lt;", text)
  printf "<text x=\"%.1f\" y=\"%d\" fill=\"%s\"%s>%s</text>\n", at, y, colour, how == "" ? "" : " " how, text
}
