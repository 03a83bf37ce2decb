open Scc_geometry

(* Sort and sweep along x. *)

let compare_pair (i, j) (k, l) =
  let c = Int.compare i k in
  if c <> 0 then c else Int.compare j l

let pairs boxes =
  let n = Array.length boxes in
  let lows = Array.map (fun box -> Float_box.low box 0) boxes in
  let by_low i j = Float.compare (lows.(i)) (lows.(j)) in
  let sorted = Array.init n Fun.id in
  Array.stable_sort by_low sorted;
  let found = ref [] in
  for k = 0 to n - 1 do
    let i = sorted.(k) in
    let last = Float_box.high boxes.(i) 0 in
    let next = ref (k + 1) in
    while !next < n && Float_box.low boxes.(sorted.(!next)) 0 <= last do
      let j = sorted.(!next) in
      if Float_box.meet boxes.(i) boxes.(j) then found := (Int.min i j, Int.max i j) :: !found;
      incr next
    done
  done;
  List.sort compare_pair !found
