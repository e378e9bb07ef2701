# What Slurm does to the tasks of an array is done by hand.
slurm=$(dirname "$0")/../../../examples/slurm
export SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_COUNT=2 SLURM_CPUS_PER_TASK=1
cp fixtures/puffs/puff.000[1245].vdb .
touch -d 2001-01-01 puff.*
task() { SLURM_ARRAY_TASK_ID=$1 "$slurm/frames" "$2" solve 'puff.####.vdb' -o 'r.####.vdb' --scale 2 -q; }
task 0 1-2,5-4
echo $?
"$slurm/summary" 1-2,5-4 murk-7_*.jsonl | sed 's/[0-9.]* s of/S s of/'
task 1 1-2,5-4
echo $?
cp puff.0001.vdb puff.0005.vdb
touch -d 2001-01-01 puff.0005.vdb
task 1 1-2,5-4
echo $?
"$slurm/summary" 1-5 murk-7_*.jsonl | sed 's/[0-9.]* s of/S s of/'
grep -c . murk-7_1.jsonl
cp puff.0001.vdb puff.0006.vdb
SLURM_MEM_PER_NODE=1 task 0 6,6
echo $?
rm puff.*
