$front << EOD
0.1 8 # backward-euler h=1/30
0.2 2 # tr-bdf2 h=1/30
0.4 0.5 # tr-bdf2 h=1/60
0.8 0.125 # tr-bdf2 h=1/120
3 0.02 # tr-bdf2 h=1/480, below
EOD
$line1 << EOD
0.1 8 # backward-euler h=1/30
0.2 4 # backward-euler h=1/60
0.4 2 # backward-euler h=1/120
EOD
$line2 << EOD
0.2 2 # tr-bdf2 h=1/30
0.4 0.5 # tr-bdf2 h=1/60
0.8 0.125 # tr-bdf2 h=1/120
3 0.02 # tr-bdf2 h=1/480, below
EOD
$line3 << EOD
0.5 3 # the scene
EOD
$line4 << EOD
0.4 0.5 # tr-bdf2 h=1/60
EOD
reset
set terminal svg background 'white' font 'sans,30' size 1280,720
set output 'out/trade.svg'
set logscale xy
set border lw 2
set xrange [0.0227573:3.95477]
set yrange [0.00920032:12.9198]
set lmargin at screen 0.0781
set rmargin at screen 0.6719
set bmargin at screen 0.2222
set tmargin at screen 0.8472
set xtics nomirror ('0.1' 0.1, '1' 1)
set ytics nomirror ('0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10)
set grid lc rgb '#cccccc' lw 1 dt 1
unset key
set logscale y2
set y2tics nomirror ('0.1' 0.1, '1' 1, '10' 10, '100' 100)
set y2range [0.0920032:129.198]
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.02 fc rgb '#d8d8d8' fs solid noborder behind
set arrow from first 1, graph 0 to first 1, graph 1 nohead lw 4 dt 1 lc rgb '#000000' back
set arrow from graph 0, first 1 to graph 1, first 1 nohead lw 4 dt 1 lc rgb '#0000c8' back
set label 'advice: tr-bdf2 h=1/60' at screen 0.0156, screen 0.0917 left noenhanced front tc rgb '#640000' font ',23'
set label '' at first 0.03, graph 0.97 point pt 2 ps 2 lw 4 lc rgb '#640000' front
set label 'x central-difference h=auto: the forces are not finite' at screen 0.0156, screen 0.0556 left noenhanced front tc rgb '#640000' font ',23'
set label 'a "scene"' at screen 0.0781, screen 0.9514 left noenhanced front tc rgb '#000000' font ',30'
set label '% of the size: time error on the mesh of the scene' at screen 0.0312, screen 0.8847 left noenhanced front tc rgb '#000000' font ',23'
set label 'seconds of computing for a simulated second' at screen 0.1497, screen 0.1361 left noenhanced front tc rgb '#000000' font ',23'
set label 'pixels at 1080p' at screen 0.5912, screen 0.8847 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.7578, screen 0.8306 to screen 0.7953, screen 0.8306 nohead front lw 14 lc rgb '#ffd880'
set label 'front' at screen 0.8031, screen 0.8306 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.7578, screen 0.7861 to screen 0.7953, screen 0.7861 nohead front lw 6 dt 1 lc rgb '#600000'
set arrow from screen 0.7578, screen 0.7861 to screen 0.7953, screen 0.7861 nohead front lw 3 dt 2 lc rgb '#ff3030'
set label '' at screen 0.7766, screen 0.7861 point pt 5 ps 2.80 lw 1.0 lc rgb '#ff3030' front
set label '' at screen 0.7766, screen 0.7861 point pt 4 ps 2.80 lw 3.0 lc rgb '#600000' front
set label '' at screen 0.7766, screen 0.7861 point pt 5 ps 0.98 lw 1.0 lc rgb '#ffffff' front
set label 'backward-euler' at screen 0.8031, screen 0.7861 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.7578, screen 0.7417 to screen 0.7953, screen 0.7417 nohead front lw 6 dt 1 lc rgb '#0000c8'
set arrow from screen 0.7578, screen 0.7417 to screen 0.7953, screen 0.7417 nohead front lw 3 dt 1 lc rgb '#3878ff'
set label '' at screen 0.7766, screen 0.7417 point pt 7 ps 2.80 lw 1.0 lc rgb '#3878ff' front
set label '' at screen 0.7766, screen 0.7417 point pt 6 ps 2.80 lw 3.0 lc rgb '#0000c8' front
set label 'tr-bdf2' at screen 0.8031, screen 0.7417 left noenhanced front tc rgb '#000000' font ',23'
set label 'real time' at screen 0.5183, screen 0.8139 left noenhanced front tc rgb '#000000' font ',30'
set label 'target' at screen 0.5869, screen 0.6543 left noenhanced front tc rgb '#0000c8' font ',30'
set label 'below' at screen 0.0844, screen 0.2586 left noenhanced front tc rgb '#000000' font ',30'
set label 'advice' at screen 0.2894, screen 0.5668 left noenhanced front tc rgb '#640000' font ',30'
set label 'the scene' at screen 0.3719, screen 0.7824 left noenhanced front tc rgb '#000000' font ',30'
set label 'order 1' at screen 0.3216, screen 0.3590 left noenhanced front tc rgb '#000000' font ',23'
set label 'order 2' at screen 0.3216, screen 0.4201 left noenhanced front tc rgb '#000000' font ',23'
set label '1/30' at screen 0.1928, screen 0.8059 left noenhanced front tc rgb '#600000' font ',23'
set label '1/30' at screen 0.2726, screen 0.6863 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.4362, screen 0.5668 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/120' at screen 0.5160, screen 0.4472 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/480' at screen 0.6135, screen 0.2531 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.3075, screen 0.7822 left noenhanced front tc rgb '#600000' font ',23'
set label '1/120' at screen 0.3815, screen 0.6502 left noenhanced front tc rgb '#600000' font ',23'
set arrow from first 0.352074, first 0.024573 to first 0.715129, first 0.024573 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.024573 to first 0.352074, first 0.0499124 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.0499124 to first 0.715129, first 0.024573 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.024573 to first 0.715129, first 0.024573 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.024573 to first 0.352074, first 0.101382 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.101382 to first 0.715129, first 0.024573 nohead lw 2 lc rgb '#000000' front
plot $front using 1:2 with lines lw 14 lc rgb '#ffd880', \
  $line1 using 1:2 with lines lw 6 dt 1 lc rgb '#600000', \
  $line1 using 1:2 with lines lw 3 dt 2 lc rgb '#ff3030', \
  $line2 using 1:2 with lines lw 6 dt 1 lc rgb '#0000c8', \
  $line2 using 1:2 with lines lw 3 dt 1 lc rgb '#3878ff', \
  $line1 using 1:2 with points pt 5 ps 2.80 lw 1.0 lc rgb '#ff3030', \
  $line1 using 1:2 with points pt 4 ps 2.80 lw 3.0 lc rgb '#600000', \
  $line1 using 1:2 with points pt 5 ps 0.98 lw 1.0 lc rgb '#ffffff', \
  $line2 using 1:2 with points pt 7 ps 2.80 lw 1.0 lc rgb '#3878ff', \
  $line2 using 1:2 with points pt 6 ps 2.80 lw 3.0 lc rgb '#0000c8', \
  $line3 using 1:2 with points pt 5 ps 3.36 lw 3.0 lc rgb '#000000', \
  $line4 using 1:2 with points pt 6 ps 5.04 lw 3.0 lc rgb '#640000'
unset output
reset
set terminal pngcairo fontscale 0.75 font 'sans,30' size 1280,720
set output 'out/trade.png'
set logscale xy
set border lw 2
set xrange [0.0227573:3.95477]
set yrange [0.00920032:12.9198]
set lmargin at screen 0.0781
set rmargin at screen 0.6719
set bmargin at screen 0.2222
set tmargin at screen 0.8472
set xtics nomirror ('0.1' 0.1, '1' 1)
set ytics nomirror ('0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10)
set grid lc rgb '#cccccc' lw 1 dt 1
unset key
set logscale y2
set y2tics nomirror ('0.1' 0.1, '1' 1, '10' 10, '100' 100)
set y2range [0.0920032:129.198]
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.02 fc rgb '#d8d8d8' fs solid noborder behind
set arrow from first 1, graph 0 to first 1, graph 1 nohead lw 4 dt 1 lc rgb '#000000' back
set arrow from graph 0, first 1 to graph 1, first 1 nohead lw 4 dt 1 lc rgb '#0000c8' back
set label 'advice: tr-bdf2 h=1/60' at screen 0.0156, screen 0.0917 left noenhanced front tc rgb '#640000' font ',23'
set label '' at first 0.03, graph 0.97 point pt 2 ps 2 lw 4 lc rgb '#640000' front
set label 'x central-difference h=auto: the forces are not finite' at screen 0.0156, screen 0.0556 left noenhanced front tc rgb '#640000' font ',23'
set label 'a "scene"' at screen 0.0781, screen 0.9514 left noenhanced front tc rgb '#000000' font ',30'
set label '% of the size: time error on the mesh of the scene' at screen 0.0312, screen 0.8847 left noenhanced front tc rgb '#000000' font ',23'
set label 'seconds of computing for a simulated second' at screen 0.1497, screen 0.1361 left noenhanced front tc rgb '#000000' font ',23'
set label 'pixels at 1080p' at screen 0.5912, screen 0.8847 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.7578, screen 0.8306 to screen 0.7953, screen 0.8306 nohead front lw 14 lc rgb '#ffd880'
set label 'front' at screen 0.8031, screen 0.8306 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.7578, screen 0.7861 to screen 0.7953, screen 0.7861 nohead front lw 6 dt 1 lc rgb '#600000'
set arrow from screen 0.7578, screen 0.7861 to screen 0.7953, screen 0.7861 nohead front lw 3 dt 2 lc rgb '#ff3030'
set label '' at screen 0.7766, screen 0.7861 point pt 5 ps 2.80 lw 1.0 lc rgb '#ff3030' front
set label '' at screen 0.7766, screen 0.7861 point pt 4 ps 2.80 lw 3.0 lc rgb '#600000' front
set label '' at screen 0.7766, screen 0.7861 point pt 5 ps 0.98 lw 1.0 lc rgb '#ffffff' front
set label 'backward-euler' at screen 0.8031, screen 0.7861 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.7578, screen 0.7417 to screen 0.7953, screen 0.7417 nohead front lw 6 dt 1 lc rgb '#0000c8'
set arrow from screen 0.7578, screen 0.7417 to screen 0.7953, screen 0.7417 nohead front lw 3 dt 1 lc rgb '#3878ff'
set label '' at screen 0.7766, screen 0.7417 point pt 7 ps 2.80 lw 1.0 lc rgb '#3878ff' front
set label '' at screen 0.7766, screen 0.7417 point pt 6 ps 2.80 lw 3.0 lc rgb '#0000c8' front
set label 'tr-bdf2' at screen 0.8031, screen 0.7417 left noenhanced front tc rgb '#000000' font ',23'
set label 'real time' at screen 0.5183, screen 0.8139 left noenhanced front tc rgb '#000000' font ',30'
set label 'target' at screen 0.5869, screen 0.6543 left noenhanced front tc rgb '#0000c8' font ',30'
set label 'below' at screen 0.0844, screen 0.2586 left noenhanced front tc rgb '#000000' font ',30'
set label 'advice' at screen 0.2894, screen 0.5668 left noenhanced front tc rgb '#640000' font ',30'
set label 'the scene' at screen 0.3719, screen 0.7824 left noenhanced front tc rgb '#000000' font ',30'
set label 'order 1' at screen 0.3216, screen 0.3590 left noenhanced front tc rgb '#000000' font ',23'
set label 'order 2' at screen 0.3216, screen 0.4201 left noenhanced front tc rgb '#000000' font ',23'
set label '1/30' at screen 0.1928, screen 0.8059 left noenhanced front tc rgb '#600000' font ',23'
set label '1/30' at screen 0.2726, screen 0.6863 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.4362, screen 0.5668 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/120' at screen 0.5160, screen 0.4472 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/480' at screen 0.6135, screen 0.2531 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.3075, screen 0.7822 left noenhanced front tc rgb '#600000' font ',23'
set label '1/120' at screen 0.3815, screen 0.6502 left noenhanced front tc rgb '#600000' font ',23'
set arrow from first 0.352074, first 0.024573 to first 0.715129, first 0.024573 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.024573 to first 0.352074, first 0.0499124 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.0499124 to first 0.715129, first 0.024573 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.024573 to first 0.715129, first 0.024573 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.024573 to first 0.352074, first 0.101382 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.352074, first 0.101382 to first 0.715129, first 0.024573 nohead lw 2 lc rgb '#000000' front
plot $front using 1:2 with lines lw 14 lc rgb '#ffd880', \
  $line1 using 1:2 with lines lw 6 dt 1 lc rgb '#600000', \
  $line1 using 1:2 with lines lw 3 dt 2 lc rgb '#ff3030', \
  $line2 using 1:2 with lines lw 6 dt 1 lc rgb '#0000c8', \
  $line2 using 1:2 with lines lw 3 dt 1 lc rgb '#3878ff', \
  $line1 using 1:2 with points pt 5 ps 2.80 lw 1.0 lc rgb '#ff3030', \
  $line1 using 1:2 with points pt 4 ps 2.80 lw 3.0 lc rgb '#600000', \
  $line1 using 1:2 with points pt 5 ps 0.98 lw 1.0 lc rgb '#ffffff', \
  $line2 using 1:2 with points pt 7 ps 2.80 lw 1.0 lc rgb '#3878ff', \
  $line2 using 1:2 with points pt 6 ps 2.80 lw 3.0 lc rgb '#0000c8', \
  $line3 using 1:2 with points pt 5 ps 3.36 lw 3.0 lc rgb '#000000', \
  $line4 using 1:2 with points pt 6 ps 5.04 lw 3.0 lc rgb '#640000'
unset output
