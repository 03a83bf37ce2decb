type 'a t = {
  near : 'a -> float;
  compare : 'a -> 'a -> int;
  mutable keys : float array;  (** what is near to each entry *)
  mutable entries : 'a array;
  mutable size : int;
}

let create ~near ~compare = { near; compare; keys = [||]; entries = [||]; size = 0 }
let size a = a.size

let before a (key : float) entry other_key other =
  key < other_key || (key = other_key && a.compare entry other < 0)

let put a i key entry =
  a.keys.(i) <- key;
  a.entries.(i) <- entry

(* Each place has four below it: half as many levels as with two, and the keys of the four are neighbours in
   memory. *)
let arity = 4

(* Lets the place [i] rise until what is above is not greater, and puts the entry there. *)
let rec rise a i key entry =
  let above = (i - 1) / arity in
  if i > 0 && before a key entry a.keys.(above) a.entries.(above) then begin
    put a i a.keys.(above) a.entries.(above);
    rise a above key entry
  end
  else put a i key entry

let rec sink a i key entry =
  let from = (arity * i) + 1 in
  if from >= a.size then put a i key entry
  else begin
    let below = ref from in
    for j = from + 1 to Int.min (a.size - 1) (from + arity - 1) do
      if before a a.keys.(j) a.entries.(j) a.keys.(!below) a.entries.(!below) then below := j
    done;
    let below = !below in
    if before a a.keys.(below) a.entries.(below) key entry then begin
      put a i a.keys.(below) a.entries.(below);
      sink a below key entry
    end
    else put a i key entry
  end

let grow a entry =
  let n = Int.max 16 (2 * a.size) in
  let keys = Array.make n 0. and entries = Array.make n entry in
  Array.blit a.keys 0 keys 0 a.size;
  Array.blit a.entries 0 entries 0 a.size;
  a.keys <- keys;
  a.entries <- entries

let add a entry =
  if a.size = Array.length a.entries then grow a entry;
  a.size <- a.size + 1;
  rise a (a.size - 1) (a.near entry) entry

let first a = if a.size = 0 then None else Some a.entries.(0)

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

let take a =
  let taken = first a in
  drop_first a;
  taken

let shrink a =
  let spare = Int.max 16 (2 * a.size) in
  if Array.length a.entries > spare then begin
    a.keys <- Array.sub a.keys 0 spare;
    a.entries <- Array.sub a.entries 0 spare
  end;
  Array.fill a.entries a.size (Array.length a.entries - a.size) a.entries.(0)

let keep a wanted =
  let kept = ref 0 in
  for i = 0 to a.size - 1 do
    if wanted a.entries.(i) then begin
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
    shrink a;
    for i = (a.size - 1) / arity downto 0 do
      sink a i a.keys.(i) a.entries.(i)
    done
  end
