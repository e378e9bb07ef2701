# A ball is as bright on its right from the right as on its left from the left.
bake() { murk bake fixtures/puff.vdb --scale 5 --albedo 0.9 --size 26x26 --threads 1 --tolerance 0.3% -q "$@"; }
same() { oiiotool "$@" --fail 0.002 --warn 0.002 --diff | tail -1; }
bake -o a.exr
same a_positive.exr --ch R --flop a_negative.exr --ch R
same a_positive.exr --ch G --flip a_negative.exr --ch G
same a_positive.exr --ch R --flop --rotate90 a_positive.exr --ch G --flop
same a_positive.exr --ch R a_negative.exr --ch R # which differ
same a_positive.exr --ch B a_negative.exr --ch B # so do back and front
# Straight is premultiplied over the opacity; 8 bits hold both as they are.
bake --straight -o s.exr
bake -o p.png
same a_positive.exr --ch R,G,B a_positive.exr --ch A,A,A --div s_positive.exr --ch R,G,B
oiiotool --no-autopremult -i p_positive.png -i a_positive.exr --fail 0.005 --warn 0.005 --diff | tail -1
oiiotool --no-autopremult -i p_negative.png -i a_negative.exr --fail 0.005 --warn 0.005 --diff | tail -1
