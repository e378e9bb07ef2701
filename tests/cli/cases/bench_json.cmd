murk bench --cases cloud --sizes 600 --runs 1 --parts growth,emptiness,threads,error --packets 1e3,1e4 --threads 2 -q --json | /usr/bin/python3 -c "
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
print([row['tolerance'] for row in errors if row['method'] == 'lines' and not row['reference'] and row['case'] == 'cloud'])
print([row['window'] for row in errors if row['method'].startswith('pairwise') and row['case'] == 'cloud'])
print([row['packets'] for row in errors if row['method'] == 'Monte Carlo' and row['case'] == 'cloud'])
print(all(row['error'] <= row['tolerance'] for row in errors if row['method'] == 'lines' and not row['reference']))
print(report['exponents'])"
