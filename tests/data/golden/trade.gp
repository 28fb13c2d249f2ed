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
set lmargin at screen 0.1000
set rmargin at screen 0.6641
set bmargin at screen 0.2083
set tmargin at screen 0.8750
set ylabel '% of the size' offset 0.5,0
set xtics nomirror ('0.1' 0.1, '1' 1)
set ytics nomirror ('0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10)
set grid lc rgb '#cccccc' lw 1 dt 1
set logscale y2
set y2tics nomirror ('0.1' 0.1, '1' 1, '10' 10, '100' 100)
set y2label 'pixels at 1080p' offset -2.2,0
set y2range [0.0920032:129.198]
set key at screen 0.998,0.87 right top Left reverse noenhanced samplen 1.2 spacing 1.1 font ',23'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.02 fc rgb '#d8d8d8' fs solid noborder behind
set arrow from first 1, graph 0 to first 1, graph 1 nohead lw 4 dt 1 lc rgb '#000000' back
set arrow from graph 0, first 1 to graph 1, first 1 nohead lw 4 dt 1 lc rgb '#0000c8' back
set label '' at first 0.03, graph 0.97 point pt 2 ps 2 lw 4 lc rgb '#640000' front
set label 'x central-difference h=auto: the forces are not finite' at screen 0.0156, screen 0.0583 left noenhanced front tc rgb '#640000' font ',23'
set label 'a "scene"' at screen 0.1000, screen 0.9583 left noenhanced front tc rgb '#000000' font ',30'
set label 'time error on the mesh of the scene' at screen 0.1000, screen 0.9056 left noenhanced front tc rgb '#000000' font ',23'
set label 'seconds of computing for a simulated second' at screen 0.1469, screen 0.1167 left noenhanced front tc rgb '#000000' font ',30'
set label 'real time' at screen 0.5184, screen 0.8417 left noenhanced front tc rgb '#000000' font ',30'
set label 'target' at screen 0.5763, screen 0.6674 left noenhanced front tc rgb '#0000c8' font ',30'
set label 'below' at screen 0.1062, screen 0.2492 left noenhanced front tc rgb '#000000' font ',30'
set label 'advice' at screen 0.4244, screen 0.5759 left noenhanced front tc rgb '#640000' font ',30'
set label 'the scene' at screen 0.3767, screen 0.7879 left noenhanced front tc rgb '#000000' font ',30'
set label 'order 1' at screen 0.1273, screen 0.3957 left noenhanced front tc rgb '#000000' font ',23'
set label 'order 2' at screen 0.1273, screen 0.4716 left noenhanced front tc rgb '#000000' font ',23'
set label '1/30' at screen 0.2728, screen 0.8309 left noenhanced front tc rgb '#640000' font ',23'
set label '1/30' at screen 0.3486, screen 0.7034 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.3609, screen 0.5759 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/120' at screen 0.4262, screen 0.4483 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/480' at screen 0.6078, screen 0.3103 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.2851, screen 0.7671 left noenhanced front tc rgb '#640000' font ',23'
set label '1/120' at screen 0.4244, screen 0.7034 left noenhanced front tc rgb '#640000' font ',23'
set arrow from first 0.0279719, first 0.0308942 to first 0.0638442, first 0.0308942 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.0308942 to first 0.0279719, first 0.0705143 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.0705143 to first 0.0638442, first 0.0308942 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.0308942 to first 0.0638442, first 0.0308942 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.0308942 to first 0.0279719, first 0.160945 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.160945 to first 0.0638442, first 0.0308942 nohead lw 2 lc rgb '#000000' front
plot $front using 1:2 with lines lw 14 lc rgb '#ffd880' title 'front', \
  $line1 using 1:2 with linespoints pt 5 ps 1.6 lw 3 dt 2 lc rgb '#640000' title 'backward-euler', \
  $line2 using 1:2 with linespoints pt 7 ps 1.6 lw 3 dt 1 lc rgb '#0000c8' title 'tr-bdf2', \
  $line3 using 1:2 with points pt 5 ps 3.2 lw 3 dt 1 lc rgb '#000000' notitle, \
  $line4 using 1:2 with points pt 6 ps 4.8 lw 3 dt 1 lc rgb '#640000' notitle
unset output
reset
set terminal pngcairo fontscale 0.75 font 'sans,30' size 1280,720
set output 'out/trade.png'
set logscale xy
set border lw 2
set xrange [0.0227573:3.95477]
set yrange [0.00920032:12.9198]
set lmargin at screen 0.1000
set rmargin at screen 0.6641
set bmargin at screen 0.2083
set tmargin at screen 0.8750
set ylabel '% of the size' offset 0.5,0
set xtics nomirror ('0.1' 0.1, '1' 1)
set ytics nomirror ('0.01' 0.01, '0.1' 0.1, '1' 1, '10' 10)
set grid lc rgb '#cccccc' lw 1 dt 1
set logscale y2
set y2tics nomirror ('0.1' 0.1, '1' 1, '10' 10, '100' 100)
set y2label 'pixels at 1080p' offset -2.2,0
set y2range [0.0920032:129.198]
set key at screen 0.998,0.87 right top Left reverse noenhanced samplen 1.2 spacing 1.1 font ',23'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.02 fc rgb '#d8d8d8' fs solid noborder behind
set arrow from first 1, graph 0 to first 1, graph 1 nohead lw 4 dt 1 lc rgb '#000000' back
set arrow from graph 0, first 1 to graph 1, first 1 nohead lw 4 dt 1 lc rgb '#0000c8' back
set label '' at first 0.03, graph 0.97 point pt 2 ps 2 lw 4 lc rgb '#640000' front
set label 'x central-difference h=auto: the forces are not finite' at screen 0.0156, screen 0.0583 left noenhanced front tc rgb '#640000' font ',23'
set label 'a "scene"' at screen 0.1000, screen 0.9583 left noenhanced front tc rgb '#000000' font ',30'
set label 'time error on the mesh of the scene' at screen 0.1000, screen 0.9056 left noenhanced front tc rgb '#000000' font ',23'
set label 'seconds of computing for a simulated second' at screen 0.1469, screen 0.1167 left noenhanced front tc rgb '#000000' font ',30'
set label 'real time' at screen 0.5184, screen 0.8417 left noenhanced front tc rgb '#000000' font ',30'
set label 'target' at screen 0.5763, screen 0.6674 left noenhanced front tc rgb '#0000c8' font ',30'
set label 'below' at screen 0.1062, screen 0.2492 left noenhanced front tc rgb '#000000' font ',30'
set label 'advice' at screen 0.4244, screen 0.5759 left noenhanced front tc rgb '#640000' font ',30'
set label 'the scene' at screen 0.3767, screen 0.7879 left noenhanced front tc rgb '#000000' font ',30'
set label 'order 1' at screen 0.1273, screen 0.3957 left noenhanced front tc rgb '#000000' font ',23'
set label 'order 2' at screen 0.1273, screen 0.4716 left noenhanced front tc rgb '#000000' font ',23'
set label '1/30' at screen 0.2728, screen 0.8309 left noenhanced front tc rgb '#640000' font ',23'
set label '1/30' at screen 0.3486, screen 0.7034 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.3609, screen 0.5759 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/120' at screen 0.4262, screen 0.4483 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/480' at screen 0.6078, screen 0.3103 left noenhanced front tc rgb '#0000c8' font ',23'
set label '1/60' at screen 0.2851, screen 0.7671 left noenhanced front tc rgb '#640000' font ',23'
set label '1/120' at screen 0.4244, screen 0.7034 left noenhanced front tc rgb '#640000' font ',23'
set arrow from first 0.0279719, first 0.0308942 to first 0.0638442, first 0.0308942 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.0308942 to first 0.0279719, first 0.0705143 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.0705143 to first 0.0638442, first 0.0308942 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.0308942 to first 0.0638442, first 0.0308942 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.0308942 to first 0.0279719, first 0.160945 nohead lw 2 lc rgb '#000000' front
set arrow from first 0.0279719, first 0.160945 to first 0.0638442, first 0.0308942 nohead lw 2 lc rgb '#000000' front
plot $front using 1:2 with lines lw 14 lc rgb '#ffd880' title 'front', \
  $line1 using 1:2 with linespoints pt 5 ps 1.6 lw 3 dt 2 lc rgb '#640000' title 'backward-euler', \
  $line2 using 1:2 with linespoints pt 7 ps 1.6 lw 3 dt 1 lc rgb '#0000c8' title 'tr-bdf2', \
  $line3 using 1:2 with points pt 5 ps 3.2 lw 3 dt 1 lc rgb '#000000' notitle, \
  $line4 using 1:2 with points pt 6 ps 4.8 lw 3 dt 1 lc rgb '#640000' notitle
unset output
