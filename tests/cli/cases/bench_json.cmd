murk bench --cases checkerboard --sizes 2500 --runs 1 --parts growth,emptiness,threads,error --threads 2 -q --json | /usr/bin/python3 -c "
import json, math, sys
report = json.load(sys.stdin)
print(report['murk'], report['command'])
for part in ['growth', 'emptiness', 'threads', 'error', 'paper']:
    rows = report[part]
    print(part, [(row['case'], row['method'], row['zones'], row['runs']) for row in rows])
row = report['growth'][0]
print(sorted(row))
stages = ['seconds_setup', 'seconds_light', 'seconds_solve', 'seconds_finish']
print(math.isclose(row['seconds'], sum(row[stage] for stage in stages)), row['peak_bytes'] > 4 * row['zones'])
print([row['wide'] for row in report['emptiness']], [row['threads'] for row in report['threads']])
errors = report['error']
print([row['tolerance'] for row in errors if not row['reference'] and row['case'] == 'checkerboard'])
print(all(row['error'] <= row['tolerance'] for row in errors if row['method'] == 'lines' and not row['reference']))
print(report['exponents'])"
