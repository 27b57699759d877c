# Takes out of a picture by gnuplot the groups that hold nothing, and what every reader of SVG assumes.
# usage: sed -z -f scripts/smaller_svg.sed PICTURE.svg
s/ stroke-width="1.00"//g
s/ stroke-linecap="butt" stroke-linejoin="miter"//g
:again
s/<g [^>]*>\n<\/g>\n//g
t again
