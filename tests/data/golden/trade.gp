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
set rmargin at screen 0.9102
set bmargin at screen 0.2222
set tmargin at screen 0.7569
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
set label 'a "scene"' at screen 0.0781, screen 0.9681 left noenhanced front tc rgb '#000000' font ',30'
set label '% of the size: time error on the mesh of the scene' at screen 0.0312, screen 0.7944 left noenhanced front tc rgb '#000000' font ',23'
set label 'seconds of computing for a simulated second' at screen 0.2688, screen 0.1361 left noenhanced front tc rgb '#000000' font ',23'
set label 'pixels at 1080p' at screen 0.8334, screen 0.7944 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.0781, screen 0.9181 to screen 0.1156, screen 0.9181 nohead front lw 14 lc rgb '#ffd880'
set label 'front' at screen 0.1234, screen 0.9181 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.1926, screen 0.9181 to screen 0.2301, screen 0.9181 nohead front lw 6 dt 1 lc rgb '#600000'
set arrow from screen 0.1926, screen 0.9181 to screen 0.2301, screen 0.9181 nohead front lw 3 dt 2 lc rgb '#ff3030'
set label '' at screen 0.2114, screen 0.9181 point pt 5 ps 2.80 lw 1.0 lc rgb '#ff3030' front
set label '' at screen 0.2114, screen 0.9181 point pt 4 ps 2.80 lw 3.0 lc rgb '#600000' front
set label '' at screen 0.2114, screen 0.9181 point pt 5 ps 0.98 lw 1.0 lc rgb '#ffffff' front
set label 'backward-euler' at screen 0.2379, screen 0.9181 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.4167, screen 0.9181 to screen 0.4542, screen 0.9181 nohead front lw 6 dt 1 lc rgb '#0000c8'
set arrow from screen 0.4167, screen 0.9181 to screen 0.4542, screen 0.9181 nohead front lw 3 dt 1 lc rgb '#3878ff'
set label '' at screen 0.4355, screen 0.9181 point pt 7 ps 2.80 lw 1.0 lc rgb '#3878ff' front
set label '' at screen 0.4355, screen 0.9181 point pt 6 ps 2.80 lw 3.0 lc rgb '#0000c8' front
set label 'tr-bdf2' at screen 0.4620, screen 0.9181 left noenhanced front tc rgb '#000000' font ',23'
set label 'real time' at screen 0.6930, screen 0.7236 left noenhanced front tc rgb '#000000' font ',30'
set label 'target' at screen 0.8252, screen 0.5959 left noenhanced front tc rgb '#0000c8' font ',30'
set label 'below' at screen 0.0844, screen 0.2490 left noenhanced front tc rgb '#000000' font ',30'
set label 'advice' at screen 0.5749, screen 0.5170 left noenhanced front tc rgb '#640000' font ',30'
set label 'the scene' at screen 0.5147, screen 0.7103 left noenhanced front tc rgb '#000000' font ',30'
set label 'order 1' at screen 0.7352, screen 0.4814 left noenhanced front tc rgb '#000000' font ',23'
set label 'order 2' at screen 0.7352, screen 0.5243 left noenhanced front tc rgb '#000000' font ',23'
set label '1/30' at screen 0.2612, screen 0.7216 left noenhanced front tc rgb '#600000' font ',23'
set label '1/30' at screen 0.4569, screen 0.6193 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.4707, screen 0.5170 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/120' at screen 0.6258, screen 0.3786 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/480' at screen 0.8390, screen 0.3156 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.4079, screen 0.7065 left noenhanced front tc rgb '#600000' font ',23'
set label '1/120' at screen 0.5140, screen 0.5832 left noenhanced front tc rgb '#600000' font ',23'
set arrow from first 2.08683, first 0.195101 to first 3.73149, first 0.195101 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.195101 to first 2.08683, first 0.348862 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.348862 to first 3.73149, first 0.195101 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.195101 to first 3.73149, first 0.195101 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.195101 to first 2.08683, first 0.623803 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.623803 to first 3.73149, first 0.195101 nohead lw 2 lc rgb '#000000' front
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
set rmargin at screen 0.9102
set bmargin at screen 0.2222
set tmargin at screen 0.7569
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
set label 'a "scene"' at screen 0.0781, screen 0.9681 left noenhanced front tc rgb '#000000' font ',30'
set label '% of the size: time error on the mesh of the scene' at screen 0.0312, screen 0.7944 left noenhanced front tc rgb '#000000' font ',23'
set label 'seconds of computing for a simulated second' at screen 0.2688, screen 0.1361 left noenhanced front tc rgb '#000000' font ',23'
set label 'pixels at 1080p' at screen 0.8334, screen 0.7944 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.0781, screen 0.9181 to screen 0.1156, screen 0.9181 nohead front lw 14 lc rgb '#ffd880'
set label 'front' at screen 0.1234, screen 0.9181 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.1926, screen 0.9181 to screen 0.2301, screen 0.9181 nohead front lw 6 dt 1 lc rgb '#600000'
set arrow from screen 0.1926, screen 0.9181 to screen 0.2301, screen 0.9181 nohead front lw 3 dt 2 lc rgb '#ff3030'
set label '' at screen 0.2114, screen 0.9181 point pt 5 ps 2.80 lw 1.0 lc rgb '#ff3030' front
set label '' at screen 0.2114, screen 0.9181 point pt 4 ps 2.80 lw 3.0 lc rgb '#600000' front
set label '' at screen 0.2114, screen 0.9181 point pt 5 ps 0.98 lw 1.0 lc rgb '#ffffff' front
set label 'backward-euler' at screen 0.2379, screen 0.9181 left noenhanced front tc rgb '#000000' font ',23'
set arrow from screen 0.4167, screen 0.9181 to screen 0.4542, screen 0.9181 nohead front lw 6 dt 1 lc rgb '#0000c8'
set arrow from screen 0.4167, screen 0.9181 to screen 0.4542, screen 0.9181 nohead front lw 3 dt 1 lc rgb '#3878ff'
set label '' at screen 0.4355, screen 0.9181 point pt 7 ps 2.80 lw 1.0 lc rgb '#3878ff' front
set label '' at screen 0.4355, screen 0.9181 point pt 6 ps 2.80 lw 3.0 lc rgb '#0000c8' front
set label 'tr-bdf2' at screen 0.4620, screen 0.9181 left noenhanced front tc rgb '#000000' font ',23'
set label 'real time' at screen 0.6930, screen 0.7236 left noenhanced front tc rgb '#000000' font ',30'
set label 'target' at screen 0.8252, screen 0.5959 left noenhanced front tc rgb '#0000c8' font ',30'
set label 'below' at screen 0.0844, screen 0.2490 left noenhanced front tc rgb '#000000' font ',30'
set label 'advice' at screen 0.5749, screen 0.5170 left noenhanced front tc rgb '#640000' font ',30'
set label 'the scene' at screen 0.5147, screen 0.7103 left noenhanced front tc rgb '#000000' font ',30'
set label 'order 1' at screen 0.7352, screen 0.4814 left noenhanced front tc rgb '#000000' font ',23'
set label 'order 2' at screen 0.7352, screen 0.5243 left noenhanced front tc rgb '#000000' font ',23'
set label '1/30' at screen 0.2612, screen 0.7216 left noenhanced front tc rgb '#600000' font ',23'
set label '1/30' at screen 0.4569, screen 0.6193 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.4707, screen 0.5170 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/120' at screen 0.6258, screen 0.3786 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/480' at screen 0.8390, screen 0.3156 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.4079, screen 0.7065 left noenhanced front tc rgb '#600000' font ',23'
set label '1/120' at screen 0.5140, screen 0.5832 left noenhanced front tc rgb '#600000' font ',23'
set arrow from first 2.08683, first 0.195101 to first 3.73149, first 0.195101 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.195101 to first 2.08683, first 0.348862 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.348862 to first 3.73149, first 0.195101 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.195101 to first 3.73149, first 0.195101 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.195101 to first 2.08683, first 0.623803 nohead lw 2 lc rgb '#000000' front
set arrow from first 2.08683, first 0.623803 to first 3.73149, first 0.195101 nohead lw 2 lc rgb '#000000' front
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
