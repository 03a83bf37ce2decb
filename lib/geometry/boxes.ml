open Scc_exact

let swept ((low : Vec.t), (high : Vec.t)) (d : Vec.t) =
  let down x d = if Rat.sign d < 0 then Rat.add x d else x in
  let up x d = if Rat.sign d > 0 then Rat.add x d else x in
  ( Vec.make (down low.x d.x) (down low.y d.y) (down low.z d.z),
    Vec.make (up high.x d.x) (up high.y d.y) (up high.z d.z) )

let overlap low1 high1 low2 high2 = Rat.compare low1 high2 <= 0 && Rat.compare low2 high1 <= 0

let meet ((a : Vec.t), (b : Vec.t)) ((c : Vec.t), (d : Vec.t)) =
  overlap a.x b.x c.x d.x && overlap a.y b.y c.y d.y && overlap a.z b.z c.z d.z

(* Sort and sweep along x. The coordinates are seen through floats first. Rounding to the nearest float never
   decreases when its argument grows, so that x <= y implies fl x <= fl y: two boxes that meet also meet as
   floats (were a number too great for a float, its infinity would still be in order). The floats can only let a
   pair through that does not meet, and the exact test on the pairs let through decides. *)

type shadow = {
  index : int;
  x0 : float; x1 : float;
  y0 : float; y1 : float;
  z0 : float; z1 : float;
}

let shadow index ((low : Vec.t), (high : Vec.t)) =
  let f = Rat.to_float in
  { index; x0 = f low.x; x1 = f high.x; y0 = f low.y; y1 = f high.y; z0 = f low.z; z1 = f high.z }

let by_low s t =
  let c = Float.compare s.x0 t.x0 in
  if c <> 0 then c else Int.compare s.index t.index

let compare_pair (i, j) (k, l) =
  let c = Int.compare i k in
  if c <> 0 then c else Int.compare j l

let pairs boxes =
  let sorted = Array.mapi shadow boxes in
  Array.sort by_low sorted;
  let n = Array.length sorted in
  let found = ref [] in
  for i = 0 to n - 1 do
    let s = sorted.(i) in
    let j = ref (i + 1) in
    while !j < n && sorted.(!j).x0 <= s.x1 do
      let t = sorted.(!j) in
      if s.y0 <= t.y1 && t.y0 <= s.y1 && s.z0 <= t.z1 && t.z0 <= s.z1 && meet boxes.(s.index) boxes.(t.index)
      then found := (Int.min s.index t.index, Int.max s.index t.index) :: !found;
      incr j
    done
  done;
  List.sort compare_pair !found
