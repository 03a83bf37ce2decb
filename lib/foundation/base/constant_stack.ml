(* Most lists are short: the first elements are taken by recursion, which is twice as fast; the others in two
   passes. *)
let direct = 500

module List = struct
  include Stdlib.List

  let init n f =
    if n < 0 then invalid_arg "List.init";
    let rec reversed i made = if i >= n then made else reversed (i + 1) (f i :: made) in
    rev (reversed 0 [])

  let map f list =
    let rec go left = function
      | [] -> []
      | x :: rest when left > 0 ->
        let y = f x in
        y :: go (left - 1) rest
      | rest -> rev (rev_map f rest)
    in
    go direct list

  let mapi f list =
    let rec reversed i mapped = function [] -> mapped | x :: rest -> reversed (i + 1) (f i x :: mapped) rest in
    let rec go i = function
      | [] -> []
      | x :: rest when i < direct ->
        let y = f i x in
        y :: go (i + 1) rest
      | rest -> rev (reversed i [] rest)
    in
    go 0 list

  let map2 f a b =
    let rec reversed mapped a b =
      match (a, b) with
      | [], [] -> mapped
      | x :: a, y :: b -> reversed (f x y :: mapped) a b
      | [], _ :: _ | _ :: _, [] -> invalid_arg "List.map2"
    in
    rev (reversed [] a b)

  let append a b =
    let rec go left = function
      | [] -> b
      | x :: rest when left > 0 -> x :: go (left - 1) rest
      | rest -> rev_append (rev rest) b
    in
    match b with [] -> a | _ :: _ -> go direct a

  (* The last one is kept as it is. *)
  let concat lists =
    match rev lists with [] -> [] | last :: rest -> fold_left (fun all l -> append l all) last rest

  let flatten = concat
  let fold_right f list last = fold_left (fun folded x -> f x folded) last (rev list)

  let fold_right2 f a b last =
    if not (Int.equal (compare_lengths a b) 0) then invalid_arg "List.fold_right2";
    fold_left2 (fun folded x y -> f x y folded) last (rev a) (rev b)

  let split pairs = fold_right (fun (x, y) (xs, ys) -> (x :: xs, y :: ys)) pairs ([], [])

  let combine a b =
    if not (Int.equal (compare_lengths a b) 0) then invalid_arg "List.combine";
    map2 (fun x y -> (x, y)) a b

  let merge compare a b =
    let rec go merged a b =
      match (a, b) with
      | [], rest | rest, [] -> rev_append merged rest
      | x :: a', y :: b' -> if compare x y <= 0 then go (x :: merged) a' b else go (y :: merged) a b'
    in
    go [] a b

  let without_first is_it list =
    let rec go before = function
      | [] -> list
      | x :: rest -> if is_it x then rev_append before rest else go (x :: before) rest
    in
    go [] list

  let remove_assoc key list = without_first (fun (k, _) -> Int.equal (Stdlib.compare k key) 0) list
  let remove_assq key list = without_first (fun (k, _) -> k == key) list
end

let ( @ ) = List.append
