# Draws the picture of docs/accuracy.md: a number in a recording and in a run, and their difference. Input: two files, each line a time in
# ns and the number in cm.
BEGIN { from = 3; to = 27; width = 720; left = 60; top = 20; high = 220; below = 290; low = 90; most = 1700; band = 60 }
FNR == 1 { ++file }
{ count[file]++; time[file, count[file]] = $1 / 1e9; number[file, count[file]] = $2 }
function x(t) { return left + (t - from) / (to - from) * (width - left - 20) }
function y(v) { return top + high - v / most * high }
function z(v) { return below + low - v / band * low }
function path(f,   i, text, last) {
  text = ""
  for (i = 1; i <= count[f] && time[f, i] <= to; ++i) {
    if (time[f, i] < from) { last = number[f, i]; continue }
    if (text == "") text = sprintf("M%.1f %.1f", x(from), y(last))
    text = text sprintf("L%.1f %.1f", x(time[f, i]), y(number[f, i]))
  }
  return text sprintf("L%.1f %.1f", x(to), y(number[f, i - 1]))
}
END {
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " width " 420\" font-family=\"system-ui, sans-serif\" font-size=\"13\">"
  print "<title>Height of the hook with 34 t: the finer model, read every 50 ms, and the run of the plant</title>"
  print "<style>text{fill:#57606a}.g{stroke:#d0d7de}.e{stroke:#0550ae}.a{stroke:#a04100}.e,.a,.d{fill:none;stroke-width:1.8}.d{stroke:#57606a}@media(prefers-color-scheme:dark){text{fill:#9aa4af}.g{stroke:#30363d}.e{stroke:#79c0ff}.a{stroke:#ffa657}.d{stroke:#9aa4af}}</style>"
  for (v = 0; v <= 15; v += 5) {
    printf "<line class=\"g\" x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%d m</text>\n", left, y(100 * v), width - 20, y(100 * v), left - 8, y(100 * v) + 4, v
  }
  for (v = 0; v <= 60; v += 20) {
    printf "<line class=\"g\" x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%d cm</text>\n", left, z(v), width - 20, z(v), left - 8, z(v) + 4, v
  }
  for (t = 5; t <= to; t += 5) printf "<text x=\"%.1f\" y=\"405\" text-anchor=\"middle\">%d s</text>\n", x(t), t
  print "<path class=\"e\" d=\"" path(1) "\"/>"
  print "<path class=\"a\" stroke-dasharray=\"6 3\" d=\"" path(2) "\"/>"
  j = 0
  for (i = 1; i <= count[1] && time[1, i] <= to; ++i) {
    if (time[1, i] < from) continue
    while (j < count[2] && time[2, j + 1] <= time[1, i]) ++j
    text = text sprintf("%s%.1f %.1f", text == "" ? "M" : "L", x(time[1, i]), z(number[2, j] - number[1, i]))
  }
  print "<path class=\"d\" d=\"" text "\"/>"
  print "<text x=\"" left + 12 "\" y=\"40\"><tspan class=\"k\">— recorded: the finer model, every 50 ms</tspan></text><text x=\"" left + 12 "\" y=\"58\">- - run of the plant</text><text x=\"" left + 12 "\" y=\"" below - 14 "\">run of the plant minus recorded</text>"
  print "</svg>"
}
