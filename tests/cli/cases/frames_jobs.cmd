for jobs in 1 2; do
    murk image fixtures/puffs.json --threads $jobs --jobs $jobs --frames 1-5 --json -o $jobs.####.exr >$jobs.json 2>$jobs.txt
    echo $?
done
# Apart from the command, outputs, times and what the allocator makes of sizes, lines and messages are the same, in the same order.
/usr/bin/python3 -c '
import json
def lines(name):
    for text in open(name):
        line = json.loads(text)
        for key in ("command", "outputs", "seconds", "memory"):
            line.pop(key, None)
        yield line
one, two = (list(lines(name)) for name in ("1.json", "2.json"))
print(one == two, [(line["frame"], line["status"]) for line in two])'
for jobs in 1 2; do sed -e 's/[0-9.]* s,/S s,/' -e "s/in $jobs\./in J./" $jobs.txt >$jobs.same; done
cmp 1.same 2.same && cat 2.same
for frame in 1 2 4; do
    cmp <(oiiotool --hash 1.000$frame.exr | grep SHA) <(oiiotool --hash 2.000$frame.exr | grep SHA)
done
rm [12].*
