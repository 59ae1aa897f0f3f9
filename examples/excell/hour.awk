# Writes a scenario: an hour of the cell, a cycle every 4 s. usage: awk -f hour.awk [-v cycles=900] /dev/null
function set(time, what) { step(time, "\"set\": { " what " }") }
function expect(time, what) { step(time, "\"expect\": \"" what "\"") }
function step(time, what) { printf "%s    { \"at\": \"%dms\", %s }", separator, time, what; separator = ",\n" }

BEGIN {
  if (!cycles) cycles = 900
  printf "{\n  \"symplant-scenario\": 1,\n  \"steps\": [\n"
  for (cycle = 0; cycle < cycles; cycle++) {
    t = cycle * 4000
    set(t + 500, "\"EXLINE_MB_AGV_O_P2\": true")
    set(t + 700, "\"EXLINE_MB_AGV_O_P2\": false")
    expect(t + 1500, "EXLINE_MB_AGV.P2 and EXLINE_MB_MC.IDLE1")
    set(t + 1500, "\"EXLINE_MB_MC_O_RUN2\": true")
    expect(t + 2500, "EXLINE_MB_MC.RUN2")
    set(t + 2600, "\"EXLINE_MB_MC_O_RUN2\": false, \"EXLINE_MB_MC_O_IDLE1\": true, \"EXLINE_MB_AGV_O_P1\": true")
    expect(t + 3600, "EXLINE_MB_AGV.P1 and EXLINE_MB_MC.IDLE1")
    set(t + 3700, "\"EXLINE_MB_MC_O_IDLE1\": false, \"EXLINE_MB_AGV_O_P1\": false")
  }
  printf "\n  ]\n}\n"
}
