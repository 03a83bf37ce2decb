type t = Bytes.t

let create n = Bytes.make ((n + 7) / 8) '\000'
let byte s i = Char.code (Bytes.get s (i lsr 3))
let set_byte s i x = Bytes.set s (i lsr 3) (Char.unsafe_chr x)
let mem s i = byte s i land (1 lsl (i land 7)) <> 0
let add s i = set_byte s i (byte s i lor (1 lsl (i land 7)))
let remove s i = set_byte s i (byte s i land lnot (1 lsl (i land 7)))

let init n test =
  let s = create n in
  for i = 0 to n - 1 do
    if test i then add s i
  done;
  s

let is_empty s =
  let rec from i = i = Bytes.length s || (Char.equal (Bytes.get s i) '\000' && from (i + 1)) in
  from 0
