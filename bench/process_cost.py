"""process_cost.py COMMAND...: what a process costs: seconds of the clock, seconds of CPU (user and
system), and the most memory that it held, MB. Its standard output is thrown away."""
import resource
import subprocess
import sys
import time

start = time.monotonic()
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, check=True)
seconds = time.monotonic() - start
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(f"{seconds:.4f} {used.ru_utime + used.ru_stime:.4f} {used.ru_maxrss / 1000:.1f}")
