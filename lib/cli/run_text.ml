open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_exchange

let greatest_behaviour = 160
let greatest_list = 40
let name (m : Model.t) leaf = m.leaves.(leaf).name

let bond m (b : State.bond) =
  let site (f : State.finish) = Model.site_name m ~leaf:f.at f.site in
  Printf.sprintf "<%s, {%s, %s}>" b.name (site b.one) (site b.two)

(* "p and q", "p, q and r". *)
let rec listed = function
  | [] -> ""
  | [ last ] -> last
  | [ one; last ] -> one ^ " and " ^ last
  | one :: rest -> one ^ ", " ^ listed rest

let label m : Transition.label -> string = function
  | Time d -> Printf.sprintf "time passes by %s" (Short_text.exact d)
  | Bind b ->
    Printf.sprintf "%s and %s collide and bind by %s" (name m b.one.at) (name m b.two.at) (bond m b)
  | Bounce firsts -> Printf.sprintf "%s collide and bounce" (listed (List.map (name m) firsts))
  | Weak_split b -> Printf.sprintf "%s and %s release %s" (name m b.one.at) (name m b.two.at) (bond m b)
  | Strong_split [ b ] ->
    Printf.sprintf "%s and %s react and release %s" (name m b.one.at) (name m b.two.at) (bond m b)
  | Strong_split bonds ->
    Printf.sprintf "a reaction releases %s" (String.concat ", " (List.map (bond m) bonds))

(* Cuts between code points. *)
let cut s =
  if String.length s <= greatest_behaviour then s
  else
    let rec back i = if i > 0 && Char.code s.[i] land 0xC0 = 0x80 then back (i - 1) else i in
    String.sub s 0 (back greatest_behaviour) ^ "…"

let behaviour m (l : State.leaf) = cut (State_json.behaviour m ~leaf:l.leaf l.behaviour)

let leaf m (l : State.leaf) =
  Printf.sprintf "%s at %s [%s]" (name m l.leaf) (Short_text.position m l) (behaviour m l)

let fixed (m : Model.t) (p : State.process) =
  Array.exists (fun (l : State.leaf) -> m.leaves.(l.leaf).fixed) p.leaves

let motion m (p : State.process) =
  if fixed m p then "fixed" else Short_text.motion m p

let process m (p : State.process) =
  match p.leaves with
  | [| l |] -> [ Printf.sprintf "%s, %s" (leaf m l) (motion m p) ]
  | leaves ->
    let bonds = Array.to_list (Array.map (bond m) p.bonds) in
    Printf.sprintf "one process, %s, %s" (motion m p) (String.concat " " bonds)
    :: List.map (fun l -> "  " ^ leaf m l) (Array.to_list leaves)

let state m (s : State.t) =
  let n = Array.length s.processes in
  let shown = if n > greatest_list then Array.sub s.processes 0 greatest_list else s.processes in
  let lines = if n = 0 then [ "no process" ] else List.concat_map (process m) (Array.to_list shown) in
  if n > greatest_list then lines @ [ Printf.sprintf "… and %d more processes" (n - greatest_list) ]
  else lines

(* A few digits of what may take thousands: the JSON has them all. *)
let brief q =
  let exact = Rat.to_string q in
  if String.length exact <= 12 then exact else Printf.sprintf "%.6g" (Rat.to_float q)

(* Of bounds that are less than 2^-100 apart, the lower one says enough. *)
let rounded ((t : Scc_engine.Totals.t), _) =
  let vector (v : Vec.t) = Printf.sprintf "(%s, %s, %s)" (brief v.x) (brief v.y) (brief v.z) in
  [
    "rounding has added, to six digits (the JSON tells more):";
    "  to the momentum " ^ vector t.momentum;
    "  to the angular momentum about the origin " ^ vector t.angular;
    "  to the kinetic energy " ^ brief t.energy;
  ]
