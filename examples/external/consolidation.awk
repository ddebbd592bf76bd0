# Settlement of a clay layer after Terzaghi (1943), by its series; reads the deck, writes a table over time.
{ value[$1] = $2 }
END {
  pi = 3.14159265358979
  final = value["m_v"] * value["load"] * value["thickness"]
  print "time,settlement,final"
  for (days = 0; days <= 1000; days += 50) {
    share = 1
    for (m = 0; m < 100; ++m) {
      M = pi / 2 * (2 * m + 1)
      share -= 2 / M ^ 2 * exp(-M ^ 2 * value["c_v"] * days / 365 / value["thickness"] ^ 2)
    }
    printf "%d,%.9g,%.9g\n", days, 1000 * (days == 0 ? 0 : share) * final, 1000 * final
  }
}
