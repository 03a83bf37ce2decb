open Scc_exact
open Scc_geometry
open Scc_calculus

type part = {
  process : int;
  leaf : int;
  part : int;
  position : Vec.t;
  velocity : Vec.t;
  shape : Float_box.t;
}

let of_state (m : Model.t) (s : State.t) =
  let parts_of_leaf process (p : State.process) (l : State.leaf) =
    List.mapi
      (fun part (shape : Model.part) ->
         let position = Vec.add l.position shape.offset in
         { process; leaf = l.leaf; part; position; velocity = p.velocity; shape = shape.solid.box })
      (Array.to_list m.leaves.(l.leaf).parts)
  in
  Array.to_list s.processes
  |> List.mapi (fun i (p : State.process) ->
      List.concat_map (parts_of_leaf i p) (Array.to_list p.leaves))
  |> List.concat |> Array.of_list

let in_relative_motion parts (i, j) = not (Vec.equal parts.(i).velocity parts.(j).velocity)

(* With few parts every pair is looked at: boxes would cost more than they save. *)
let few = 12

let fold_pairs f acc parts =
  let n = Array.length parts in
  let rec from i j acc =
    if i >= n - 1 then acc
    else if j = n then from (i + 1) (i + 2) acc
    else from i (j + 1) (if in_relative_motion parts (i, j) then f acc (i, j) else acc)
  in
  from 0 1 acc

let box p = Float_box.at p.position p.shape

let near parts =
  let boxes = Array.map box parts in
  if Array.length parts <= few then
    let add found (i, j) = if Float_box.meet boxes.(i) boxes.(j) then (i, j) :: found else found in
    List.rev (fold_pairs add [] parts)
  else List.filter (in_relative_motion parts) (Boxes.pairs boxes)

let all_move_alike parts =
  Array.for_all (fun p -> Vec.equal p.velocity parts.(0).velocity) parts

let near_within parts span =
  let n = Array.length parts in
  let moving = Moving_boxes.create n in
  let until = Float_box.up span in
  let sweep i p =
    Moving_boxes.set moving i p.shape ~at:p.position ~velocity:p.velocity;
    Moving_boxes.set_until moving i until;
    Moving_boxes.swept moving i ~from:0.
  in
  List.filter (in_relative_motion parts) (Boxes.pairs (Array.mapi sweep parts))

(* Sizes and speeds only say how far to look, which floats are good enough for. *)

let greatest_speed parts =
  let component best v = Float.max best (Float.abs (Rat.to_float v)) in
  Array.fold_left
    (fun best p -> component (component (component best p.velocity.x) p.velocity.y) p.velocity.z)
    0. parts

let least_size parts =
  let size p =
    let along axis = Float_box.high p.shape axis -. Float_box.low p.shape axis in
    Float.min (along 0) (Float.min (along 1) (along 2))
  in
  Array.fold_left (fun best p -> Float.min best (size p)) infinity parts

let cut limit span = match limit with None -> span | Some l -> Rat.min l span

(* A power of two about as great as a float: a short number, which keeps the ends of the sweeps short. Of a float
   that is zero or infinite, any will do. *)
let power_of_two x =
  let _, exponent = Float.frexp x in
  let exponent = Int.max (-1000) (Int.min 1000 exponent) in
  if exponent >= 0 then Rat.make (Z.shift_left Z.one exponent) Z.one
  else Rat.make Z.one (Z.shift_left Z.one (-exponent))

let first_window parts ~limit =
  if Array.length parts <= few || Array.for_all (fun p -> Vec.is_zero p.velocity) parts then None
  else Some (cut limit (power_of_two (least_size parts /. greatest_speed parts)))

(* Sweeps of bodies that fly apart never meet, however wide the window: without a limit the rounds must end. *)
let most_rounds = 10

let wider parts ~limit ~met ~round span =
  let n = Array.length parts in
  if met > n * n / 8 || (Option.is_none limit && round >= most_rounds) then None
  else Some (cut limit (Rat.mul (Rat.of_int 4) span))
