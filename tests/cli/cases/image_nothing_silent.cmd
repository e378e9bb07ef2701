murk image fixtures/puff.json -q -o a.exr
oiiotool a.exr --ch R,G,B,A --printstats | grep -E "NanCount|InfCount"
