open Scc_exact
open Scc_geometry
open Scc_calculus

type part = {
  process : int;
  leaf : int;
  part : int;
  position : Vec.t;
  velocity : Vec.t;
  low : Vec.t;
  high : Vec.t;
}

let of_state (m : Model.t) (s : State.t) =
  let parts_of_leaf process (p : State.process) (l : State.leaf) =
    List.mapi
      (fun part (shape : Model.part) ->
         let position = Vec.add l.position shape.offset in
         {
           process;
           leaf = l.leaf;
           part;
           position;
           velocity = p.velocity;
           low = Vec.add position shape.solid.low;
           high = Vec.add position shape.solid.high;
         })
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

let boxes_meet a b = Boxes.meet (a.low, a.high) (b.low, b.high)

let near parts =
  if Array.length parts <= few then
    let add found (i, j) = if boxes_meet parts.(i) parts.(j) then (i, j) :: found else found in
    List.rev (fold_pairs add [] parts)
  else
    List.filter (in_relative_motion parts)
      (Boxes.pairs (Array.map (fun p -> (p.low, p.high)) parts))

let all_move_alike parts =
  Array.for_all (fun p -> Vec.equal p.velocity parts.(0).velocity) parts

let swept span p = Boxes.swept (p.low, p.high) (Vec.scale span p.velocity)

let near_within parts span =
  List.filter (in_relative_motion parts) (Boxes.pairs (Array.map (swept span) parts))

let greatest_speed parts =
  let component best v = Rat.max best (Rat.abs v) in
  Array.fold_left
    (fun best p -> component (component (component best p.velocity.x) p.velocity.y) p.velocity.z)
    Rat.zero parts

let least_size parts =
  let size p =
    let d = Vec.sub p.high p.low in
    Rat.min d.x (Rat.min d.y d.z)
  in
  Array.fold_left (fun best p -> Rat.min best (size p)) (size parts.(0)) parts

let cut limit span = match limit with None -> span | Some l -> Rat.min l span

(* A power of two within a factor of two of a positive number: a short number, which keeps the ends of the
   sweeps short. *)
let power_of_two x =
  let exponent = Z.numbits (Q.num x) - Z.numbits (Q.den x) in
  if exponent >= 0 then Rat.make (Z.shift_left Z.one exponent) Z.one
  else Rat.make Z.one (Z.shift_left Z.one (-exponent))

let first_window parts ~limit =
  if Array.length parts <= few then None
  else
    let speed = greatest_speed parts in
    if Rat.sign speed = 0 then None
    else Some (cut limit (power_of_two (Rat.div (least_size parts) speed)))

(* Sweeps of bodies that fly apart never meet, however wide the window: without a limit the rounds must end. *)
let most_rounds = 10

let wider parts ~limit ~met ~round span =
  let n = Array.length parts in
  if met > n * n / 8 || (Option.is_none limit && round >= most_rounds) then None
  else Some (cut limit (Rat.mul (Rat.of_int 4) span))
