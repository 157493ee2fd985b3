"""What scripts that test a program from outside count: faults, each printed as it is found."""

faults = []


def check(holds, what):
    if not holds:
        faults.append(what)
        print(f"FAILED: {what}", flush=True)
