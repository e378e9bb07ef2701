# Whenever a signal comes, murk ends by it within seconds, and leaves what was there as it was.
echo before >out.exr
/usr/bin/python3 - <<'END'
import signal, subprocess, time
for number in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
    for seconds in 0.1, 0.6:
        run = subprocess.Popen(
            ["murk", "image", "volumes/plume128_f038.vdb", "--tolerance", "0.1%", "--size",
             "1920x1080", "--threads", "1", "-q", "-o", "out.exr", "--radiosity", "out.vdb"],
            preexec_fn=lambda: signal.signal(number, signal.SIG_DFL))
        time.sleep(seconds)
        run.send_signal(number)
        print(signal.Signals(-run.wait(5)).name)
END
cat out.exr
