murk bench --parts growth --cases checkerboard --sizes 200 --runs 1 --tolerance 0.0001% -q --json >report.json
status=$?
rm report.json
exit $status
