type 'key t = {
  compare : 'key -> 'key -> int;
  filler : 'key;
  mutable keys : 'key array;
  mutable values : int array;
  mutable size : int;
}

let create ~compare filler = { compare; filler; keys = [||]; values = [||]; size = 0 }

let put h i key value =
  h.keys.(i) <- key;
  h.values.(i) <- value

let push h key value =
  if h.size = Array.length h.keys then begin
    let more = Int.max 16 h.size in
    h.keys <- Array.append h.keys (Array.make more h.filler);
    h.values <- Array.append h.values (Array.make more 0)
  end;
  let rec up i =
    let parent = (i - 1) / 2 in
    if i > 0 && h.compare key h.keys.(parent) < 0 then begin
      put h i h.keys.(parent) h.values.(parent);
      up parent
    end
    else put h i key value
  in
  h.size <- h.size + 1;
  up (h.size - 1)

(* The place at i is free, and the key goes there or below. *)
let rec down h i key value =
  let child = (2 * i) + 1 in
  if child >= h.size then put h i key value
  else
    let least =
      if child + 1 < h.size && h.compare h.keys.(child + 1) h.keys.(child) < 0 then child + 1 else child
    in
    if h.compare h.keys.(least) key < 0 then begin
      put h i h.keys.(least) h.values.(least);
      down h least key value
    end
    else put h i key value

let pop h =
  if h.size = 0 then None
  else begin
    let key = h.keys.(0) and value = h.values.(0) in
    h.size <- h.size - 1;
    let last = h.keys.(h.size) and last_value = h.values.(h.size) in
    h.keys.(h.size) <- h.filler;
    if h.size > 0 then down h 0 last last_value;
    Some (key, value)
  end
