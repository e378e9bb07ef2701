again() { murk image fixtures/puffs.json -q --frames 1-2 --resume --json "$@" | grep -o '"status": "[a-z]*"' | uniq; }
again -o p.####.exr --preview p.####.png --albedo 0.8 --threads 1
echo how it runs does not matter, nor how options are written
again --output p.####.exr --preview=p.####.png --albedo=0.8 --threads 2 --jobs 1
echo another value, another option, one option less
again -o p.####.exr --preview p.####.png --albedo 0.9 --threads 1
again -o p.####.exr --preview p.####.png --albedo 0.9 --threads 1 --exposure 1
again -o p.####.exr --preview p.####.png --albedo 0.9 --threads 1
echo one of the outputs was made by another command, or does not tell
oiiotool p.0001.exr --attrib murk:command 'murk render x' -o p.0001.exr
oiiotool p.0002.png --eraseattrib murk:command -o p.0002.png
murk image fixtures/puffs.json --frames 1-2 --resume -o p.####.exr --preview p.####.png --albedo 0.9 --threads 1 -v 2>&1 | grep again
