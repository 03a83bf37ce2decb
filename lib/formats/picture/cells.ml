open Scc_exact

type box = { left : float; right : float; low : float; high : float }

(* A float of {!Rat.near_float} is off by less than 2^-51 of itself. *)
let off x = (Float.abs x *. 0x1p-50) +. 0x1p-500
let below x = if Float.abs x < infinity then x -. off x else neg_infinity
let above x = if Float.abs x < infinity then x +. off x else infinity

let around points =
  (* A number beyond all floats makes the box endless. *)
  let grow b (p : Ivec.t) =
    let x = Rat.near_float (Rat.make p.x p.z) and y = Rat.near_float (Rat.make p.y p.z) in
    {
      left = Float.min b.left (below x);
      right = Float.max b.right (above x);
      low = Float.min b.low (below y);
      high = Float.max b.high (above y);
    }
  in
  let nothing = { left = infinity; right = neg_infinity; low = infinity; high = neg_infinity } in
  Array.fold_left grow nothing points

let meet a b = a.left <= b.right && b.left <= a.right && a.low <= b.high && b.low <= a.high

type t = { whole : box; columns : int; rows : int; boxes : box array; cells : int list array }

let join a b =
  {
    left = Float.min a.left b.left;
    right = Float.max a.right b.right;
    low = Float.min a.low b.low;
    high = Float.max a.high b.high;
  }

(* Where a coordinate is among so many equal parts. Never decreasing in the coordinate, so that boxes that meet
   have a cell in common. What is no number is in the first. *)
let cell count low high x =
  let at = (x -. low) /. (high -. low) *. float_of_int count in
  if not (at > 0.) then 0 else if at >= float_of_int count then count - 1 else int_of_float at

let over t b f =
  let column = cell t.columns t.whole.left t.whole.right and row = cell t.rows t.whole.low t.whole.high in
  for y = row b.low to row b.high do
    for x = column b.left to column b.right do
      f ((y * t.columns) + x)
    done
  done

let make boxes =
  let n = Array.length boxes in
  let side = max 1 (min 100 (int_of_float (sqrt (float_of_int n)))) in
  let whole = Array.fold_left join (around [||]) boxes in
  let t = { whole; columns = side; rows = side; boxes; cells = Array.make (side * side) [] } in
  for i = n - 1 downto 0 do
    over t boxes.(i) (fun c -> t.cells.(c) <- i :: t.cells.(c))
  done;
  t

let near t b =
  let found = ref [] in
  over t b (fun c -> List.iter (fun i -> if meet t.boxes.(i) b then found := i :: !found) t.cells.(c));
  List.sort_uniq Int.compare !found
