# The second path is seen from the folder of the first; quotes of the command line stay text.
mkdir stages && murk solve fixtures/no_ground.json --scale 2 -q -o 'lit "up".vdb' --usd stages/lit.usda && cat stages/lit.usda
