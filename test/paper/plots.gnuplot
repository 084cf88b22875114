# SPDX-License-Identifier: GPL-3.0-or-later
# The plots of paper_experiments: gnuplot -e "data='FOLDER'; pictures='FOLDER'" plots.gnuplot
set terminal pngcairo size 1200,900 font "DejaVu Sans,15" background "white"
set output pictures."/fig3.png"
set palette defined (0 "#b2182b", 0.5 "#e8c872", 1 "#2b5c8a")
set cbrange [0:1]
set cblabel "g: 0 holds, 1 smooths"
set size ratio -1
unset key
unset tics
unset border
set cbtics
set xrange [-0.05:3.85]
set yrange [-0.2:1.05]
inner(c, row) = c == 1 ? row : NaN
set multiplot layout 3,1 margins 0.03,0.88,0.03,0.95 spacing 0.02,0.05
set title "a: noisy curve, g of the noisy surface, Eq. (5)"
plot data."/fig3_curve.txt" using (inner($4,$1)):2:6 with points pt 7 ps 0.7 lc palette
set title "b: the same points, g of the prefiltered surface, Eq. (6), width 0.6"
plot data."/fig3_curve.txt" using (inner($4,$1)):2:8 with points pt 7 ps 0.7 lc palette
set title "c: the same points, g of the clean surface, for comparison"
plot data."/fig3_curve.txt" using (inner($4,$1)):2:5 with points pt 7 ps 0.7 lc palette
unset multiplot

reset
set terminal pngcairo size 1200,600 font "DejaVu Sans,15" background "white"
set output pictures."/fig5.png"
set logscale xy
set grid lc rgb "#dddddd"
set xlabel "steps"
set ylabel "largest distance from I / width of the band"
set key left top reverse Left
set arrow from graph 0, first 1 to graph 1, first 1 nohead dt 2 lw 2 lc rgb "black"
set label "edge of the band, Eq. (8)" at graph 0.98, first 1.15 right
set xrange [1:200]
plot data."/fig5_curve.txt" using 1:2 with linespoints lw 2.5 pt 7 lc rgb "#b2182b" title "well-posed (6)", \
     "" using 1:5 with linespoints lw 2.5 pt 5 lc rgb "#d6604d" title "volume-preserving (7), L=4", \
     "" using 1:6 with linespoints lw 2.5 pt 9 lc rgb "#e0a030" title "balanced (9), L=4", \
     "" using 1:4 with linespoints lw 2.5 pt 11 lc rgb "#4393c3" title "balanced (9), static", \
     "" using 1:3 with linespoints lw 2.5 pt 13 lc rgb "#2b5c8a" title "volume-preserving (7), static"

reset
set terminal pngcairo size 1200,520 font "DejaVu Sans,15" background "white"
set output pictures."/fig6_error.png"
set logscale y
set grid lc rgb "#dddddd"
set xlabel "steps"
set ylabel "E(u, M0), % of the radius"
set arrow from 0, 0.496 to 30, 0.496 nohead dt 2 lw 2 lc rgb "black"
set label "the paper: 0.12 / 24.20" at 29.7, 0.8 right
set key outside top center horizontal
plot data."/fig6_curve.txt" using 1:2 with linespoints lw 2.5 pt 7 lc rgb "#2b5c8a" title "volume-preserving (7)", \
     "" using 1:4 with linespoints lw 2.5 pt 5 lc rgb "#66a61e" title "volume-preserving (7), default estimator", \
     "" using 1:3 with linespoints lw 2.5 pt 9 lc rgb "#b2182b" title "balanced (9)"
