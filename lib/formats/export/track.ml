open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_motion

type key = { time : Rat.t; at : Vec.t; turned : Quaternion.t }
type t = { keys : key array; gone : Rat.t option }

type growing = {
  mutable newest : key list;
  mutable going : Vec.t option;  (** up to the newest key it has gone straight, with this velocity *)
  mutable left : Rat.t option;
}

let key time (l : State.leaf) = { time; at = l.position; turned = l.turned }
let same_pose a b = Vec.equal a.at b.at && Quaternion.equal a.turned b.turned

(* Of two keys of one instant the later counts. *)
let put g k =
  match g.newest with
  | last :: older when Rat.equal last.time k.time -> g.newest <- k :: older
  | all -> g.newest <- k :: all

let rest_of g k =
  (match g.newest with
   | last :: _ when same_pose last k -> ()
   | _ -> put g k);
  g.going <- None

let straight g velocity from until =
  (match (g.going, g.newest) with
   | Some v, last :: older when Vec.equal v velocity && Rat.equal last.time from.time && same_pose last from ->
     g.newest <- until :: older
   | _ ->
     put g from;
     put g until);
  g.going <- Some velocity

(* {1 Stretches} *)

(* In a time d a process turns by less than |w| d: the number of steps of a tenth of a radian. *)
let steps (p : State.process) d =
  let tenths = Rat.mul (Rat.of_int 100) (Rat.mul (Vec.norm2 p.spin) (Rat.mul d d)) in
  1 + Z.to_int (Rat.floor (Rat.root tenths))

(* A process over a time in which no turn ends. *)
let process model growing start d (p : State.process) =
  let path = Path.make model p in
  let keys offset =
    let at = if Rat.sign offset = 0 then p else Path.at path offset in
    Array.map (key (Rat.add start offset)) at.leaves
  in
  if Turn.spinning p then
    let n = steps p d in
    for i = 0 to n do
      let offset = Rat.mul d (Rat.make (Z.of_int i) (Z.of_int n)) in
      Array.iteri
        (fun j k ->
           let g = growing.(p.leaves.(j).leaf) in
           put g k;
           g.going <- None)
        (keys offset)
    done
  else if Vec.is_zero p.velocity then
    Array.iter (fun (l : State.leaf) -> rest_of growing.(l.leaf) (key start l)) p.leaves
  else
    let until = keys d in
    Array.iteri
      (fun j (l : State.leaf) -> straight growing.(l.leaf) p.velocity (key start l) until.(j))
      p.leaves

let stretch model growing start d (s : State.t) = Array.iter (process model growing start d) s.processes

(* {1 Runs} *)

let settle growing time (s : State.t) =
  let leaf (l : State.leaf) =
    let g = growing.(l.leaf) and k = key time l in
    match g.newest with last :: _ when same_pose last k -> () | _ -> put g k
  in
  Array.iter (fun (p : State.process) -> Array.iter leaf p.leaves) s.processes

let leave model growing time s =
  List.iter
    (fun leaf ->
       let g = growing.(leaf) in
       if Option.is_none g.left then g.left <- Some time)
    (State.gone model s)

let grow model = Array.map (fun _ -> { newest = []; going = None; left = None }) model.Model.leaves

let finish g =
  match g.newest with
  | [] -> { keys = [| { time = Rat.zero; at = Vec.zero; turned = Quaternion.identity } |]; gone = Some Rat.zero }
  | keys -> { keys = Array.of_list (List.rev keys); gone = g.left }

let of_course course =
  let semantics = Course.semantics course in
  let model = Semantics.model semantics in
  let growing = grow model in
  settle growing Rat.zero (Course.initial course);
  leave model growing Rat.zero (Course.initial course);
  let leg (l : Course.leg) =
    match l.label with
    | Time d -> stretch model growing l.start d l.before
    | Absorb _ -> leave model growing l.start l.after
    | Bind _ | Close _ | Bounce _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> ()
  in
  Array.iter leg (Course.legs course);
  let over = Rat.sub (Course.duration course) (Course.rest course) in
  settle growing over (Course.last course);
  let piece ~start ~lasts s = stretch model growing start lasts s in
  Ray.follow semantics ~start:over ~lasts:(Course.rest course) (Course.last course) piece;
  Array.map finish growing

(* From one change of its process to the next; in one instant nothing moves. *)
let of_ways w =
  let growing = grow (Ways.model w) in
  let way g leaf (from : Ways.way) until =
    match from.process with
    | None -> if Option.is_none g.left then g.left <- Some from.since
    | Some p ->
      g.left <- None;
      let k = key from.since (State.leaf_of p leaf) and d = Rat.sub until from.since in
      if Rat.sign d = 0 then (if g.newest = [] then put g k)
      else if Vec.is_zero p.velocity then rest_of g k
      else straight g p.velocity k { k with time = until; at = Vec.axpy d p.velocity k.at }
  in
  let leaf i g =
    let rec all = function
      | [] -> ()
      | from :: (next :: _ as rest) ->
        way g i from next.Ways.since;
        all rest
      | [ from ] -> way g i from (Ways.duration w)
    in
    all (Ways.of_leaf w i);
    finish g
  in
  Array.mapi leaf growing

let turns t = Array.exists (fun k -> not (Quaternion.equal k.turned t.keys.(0).turned)) t.keys
let moves t = Array.length t.keys > 1
