"""A prism over a polygon with a zigzag of six teeth, as OFF."""

outline = [(0, 0), (12, 0)] + [(12 - k, 10 + k % 2) for k in range(13)]
count = len(outline)
print("OFF")
print(2 * count, count + 2, 0)
for z in (0, 1):
    for x, y in outline:
        print(x, y, z)
print(count, *reversed(range(count)))
print(count, *range(count, 2 * count))
for k in range(count):
    after = (k + 1) % count
    print(4, k, after, count + after, count + k)
