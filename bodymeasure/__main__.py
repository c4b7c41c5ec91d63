"""`python -m bodymeasure`."""

from bodymeasure.cli import main

if __name__ == "__main__":
    main()
