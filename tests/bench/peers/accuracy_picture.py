# SPDX-FileCopyrightText: 2026 The Isago authors
# SPDX-License-Identifier: Apache-2.0
"""Draws error against core-seconds of several codes as SVG: all runs as points, the best ones of each code joined by a line."""
import math

WIDTH, HEIGHT, MARGIN = 640, 440, 60
COLOURS = ("#c0392b", "#1f5fa8", "#2e7d32")


def front(rows):
    """Runs that none beats in both error and time, cheapest first."""
    best, kept = math.inf, []
    for row in sorted(rows, key=lambda row: row["seconds"]):
        if row["error"] < best:
            best = row["error"]
            kept.append(row)
    return kept


class LogAxis:
    def __init__(self, values, low, high):
        self.first, self.last = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
        self.low, self.high = low, high

    def place(self, value):
        return self.low + (math.log10(value) - self.first) / (self.last - self.first) * (self.high - self.low)

    def ticks(self):
        return range(self.first, self.last + 1)


def axes(x, y, title):
    lines = [f'<text x="{WIDTH / 2}" y="24" text-anchor="middle">{title}</text>',
             f'<text x="{WIDTH / 2}" y="{HEIGHT - 12}" text-anchor="middle">processor time of the run [s]</text>',
             f'<text x="16" y="{HEIGHT / 2}" text-anchor="middle" transform="rotate(-90 16 {HEIGHT / 2})">error</text>']
    for n in x.ticks():
        at = x.place(10.0**n)
        lines += [f'<path d="M{at:.1f} {y.low}V{y.high}" stroke="#ddd"/>',
                  f'<text x="{at:.1f}" y="{y.low + 18}" text-anchor="middle">10^{n}</text>']
    for n in y.ticks():
        at = y.place(10.0**n)
        lines += [f'<path d="M{x.low} {at:.1f}H{x.high}" stroke="#ddd"/>',
                  f'<text x="{x.low - 6}" y="{at + 4:.1f}" text-anchor="end">10^{n}</text>']
    return lines


def draw(path, title, rows):
    """rows: dictionaries with code, seconds, error."""
    x = LogAxis([row["seconds"] for row in rows], MARGIN, WIDTH - MARGIN / 2)
    y = LogAxis([row["error"] for row in rows], HEIGHT - MARGIN, 40)
    lines = axes(x, y, title)
    for n, code in enumerate(dict.fromkeys(row["code"] for row in rows)):
        own = [row for row in rows if row["code"] == code]
        points = " ".join(f"{x.place(row['seconds']):.1f},{y.place(row['error']):.1f}" for row in front(own))
        lines += [f'<polyline points="{points}" fill="none" stroke="{COLOURS[n]}"/>',
                  f'<text x="{WIDTH - MARGIN}" y="{60 + 18 * n}" text-anchor="end" fill="{COLOURS[n]}">{code}</text>']
        lines += [f'<circle cx="{x.place(row["seconds"]):.1f}" cy="{y.place(row["error"]):.1f}" r="3" fill="{COLOURS[n]}"/>' for row in own]
    with open(path, "w", encoding="ascii") as stream:
        stream.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="12">'
                     '<rect width="100%" height="100%" fill="white"/>\n' + "\n".join(lines) + "\n</svg>\n")
