type t = int array

let create n = Array.init n Fun.id

let rec find sets i =
  let parent = sets.(i) in
  if parent = i then i
  else begin
    sets.(i) <- sets.(parent);
    find sets sets.(i)
  end

let union sets i j =
  let a = find sets i and b = find sets j in
  if a = b then false
  else begin
    sets.(Int.max a b) <- Int.min a b;
    true
  end
