# /proc takes no new file, from root neither.
murk image fixtures/puff.json -q --size 8x8 -o /proc/a.exr
