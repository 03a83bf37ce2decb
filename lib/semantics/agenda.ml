open Scc_exact

type 'a entry = { time : Rat.t; item : 'a }

(* The nearest floats of the times stand first in every comparison. Rounding to the nearest keeps the order: of two
   times with different floats the one with the lesser float is the lesser, and when the floats are equal (or
   both infinite) the rationals decide. *)
type 'a t = { mutable keys : float array; mutable entries : 'a entry array; mutable size : int }

let create () = { keys = [||]; entries = [||]; size = 0 }
let size a = a.size

let before (key : float) (e : 'a entry) other_key (other : 'a entry) =
  key < other_key || (key = other_key && Rat.compare e.time other.time < 0)

let put a i key entry =
  a.keys.(i) <- key;
  a.entries.(i) <- entry

(* Lets the place [i] rise until what is above is not later, and puts the entry there. *)
let rec rise a i key entry =
  let above = (i - 1) / 2 in
  if i > 0 && before key entry a.keys.(above) a.entries.(above) then begin
    put a i a.keys.(above) a.entries.(above);
    rise a above key entry
  end
  else put a i key entry

let rec sink a i key entry =
  let left = (2 * i) + 1 in
  let right = left + 1 in
  if left >= a.size then put a i key entry
  else
    let below =
      if right < a.size && before a.keys.(right) a.entries.(right) a.keys.(left) a.entries.(left) then right
      else left
    in
    if before a.keys.(below) a.entries.(below) key entry then begin
      put a i a.keys.(below) a.entries.(below);
      sink a below key entry
    end
    else put a i key entry

let grow a entry =
  let n = Int.max 16 (2 * a.size) in
  let keys = Array.make n 0. and entries = Array.make n entry in
  Array.blit a.keys 0 keys 0 a.size;
  Array.blit a.entries 0 entries 0 a.size;
  a.keys <- keys;
  a.entries <- entries

let add a time item =
  let entry = { time; item } in
  if a.size = Array.length a.entries then grow a entry;
  a.size <- a.size + 1;
  rise a (a.size - 1) (Rat.to_float time) entry

let first a = if a.size = 0 then None else Some (a.entries.(0).time, a.entries.(0).item)

(* Places beyond the end repeat an entry that is still there, so that they keep nothing else alive. *)
let drop_first a =
  if a.size > 0 then begin
    a.size <- a.size - 1;
    let last = a.size in
    if last > 0 then begin
      sink a 0 a.keys.(last) a.entries.(last);
      a.entries.(last) <- a.entries.(0)
    end
    else begin
      a.keys <- [||];
      a.entries <- [||]
    end
  end

let keep a wanted =
  let kept = ref 0 in
  for i = 0 to a.size - 1 do
    if wanted a.entries.(i).item then begin
      put a !kept a.keys.(i) a.entries.(i);
      incr kept
    end
  done;
  a.size <- !kept;
  if a.size = 0 then begin
    a.keys <- [||];
    a.entries <- [||]
  end
  else begin
    let spare = Int.max 16 (2 * a.size) in
    if Array.length a.entries > spare then begin
      a.keys <- Array.sub a.keys 0 spare;
      a.entries <- Array.sub a.entries 0 spare
    end;
    Array.fill a.entries a.size (Array.length a.entries - a.size) a.entries.(0)
  end;
  for i = (a.size / 2) - 1 downto 0 do
    sink a i a.keys.(i) a.entries.(i)
  done
