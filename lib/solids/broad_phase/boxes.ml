open Scc_geometry

(* Sort and sweep along the axis along which the middles of boxes are spread most. Any axis gives the same
   pairs. *)

let compare_pair (i, j) (k, l) =
  let c = Int.compare i k in
  if c <> 0 then c else Int.compare j l

(* The variance of the middles along an axis; boxes that reach to infinity say nothing about it. *)
let spread boxes axis =
  let add (n, sum, squares) box =
    let middle = (Float_box.low box axis /. 2.) +. (Float_box.high box axis /. 2.) in
    if Float.is_finite middle then (n +. 1., sum +. middle, squares +. (middle *. middle)) else (n, sum, squares)
  in
  let n, sum, squares = Array.fold_left add (0., 0., 0.) boxes in
  (squares *. n) -. (sum *. sum)

let widest boxes =
  let wider a b = if spread boxes b > spread boxes a then b else a in
  wider (wider 0 1) 2

let pairs boxes =
  let n = Array.length boxes and axis = widest boxes in
  let lows = Array.map (fun box -> Float_box.low box axis) boxes in
  let by_low i j = Float.compare (lows.(i)) (lows.(j)) in
  let sorted = Array.init n Fun.id in
  Array.stable_sort by_low sorted;
  let found = ref [] in
  for k = 0 to n - 1 do
    let i = sorted.(k) in
    let last = Float_box.high boxes.(i) axis in
    let next = ref (k + 1) in
    while !next < n && Float_box.low boxes.(sorted.(!next)) axis <= last do
      let j = sorted.(!next) in
      if Float_box.meet boxes.(i) boxes.(j) then found := (Int.min i j, Int.max i j) :: !found;
      incr next
    done
  done;
  List.sort compare_pair !found
