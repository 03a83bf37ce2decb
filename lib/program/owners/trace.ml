open Scc_codec

let kind = 'T'
let told = 'D'

type t = {
  mesh : Mesh.t;
  part : Part.t;
  find : level:int -> int -> int option;
  is_root : int -> bool;
  runs : (int, int list) Hashtbl.t;  (** by goal; at the first owner *)
}

let make mesh part ~find ~is_root = { mesh; part; find; is_root; runs = Hashtbl.create 8 }

let put b ~goal ~level ~before choices =
  List.iter (Packed.put_nat b) [ goal; level; before ];
  Packed.put_list b Packed.put_nat choices

let message ~goal ~level ~before choices =
  let b = Buffer.create 64 in
  put b ~goal ~level ~before choices;
  Buffer.contents b

let tell t goal choices =
  if Mesh.number t.mesh = 0 then Hashtbl.replace t.runs goal choices
  else Mesh.post t.mesh 0 told (message ~goal ~level:0 ~before:0 choices)

(* From a state of this owner backwards, as far as it owns the states. *)
let rec walk t ~goal ~level id choices =
  if t.is_root id then tell t goal choices
  else
    let way = Part.way t.part id in
    let choices = way.choice :: choices and level = Int.max 0 (level - 1) in
    if way.sender = Mesh.number t.mesh then arrive t ~goal ~level way.before choices
    else Mesh.post t.mesh way.sender kind (message ~goal ~level ~before:way.before choices)

and arrive t ~goal ~level before choices =
  match t.find ~level before with
  | Some id -> walk t ~goal ~level id choices
  | None -> Scc_base.Bug.fail __POS__ "a way leads to no state"

let hear t message =
  let source = Packed.source message in
  let goal = Packed.nat source in
  let level = Packed.nat source in
  let before = Packed.nat source in
  (goal, level, before, Packed.list source Packed.nat, t)

let heard t c text =
  let goal, level, before, choices, t = hear t text in
  if Char.equal c told then Hashtbl.replace t.runs goal choices else arrive t ~goal ~level before choices

let all t (met : Progress.place option array) =
  let me = Mesh.number t.mesh in
  let start goal (place : Progress.place) =
    if place.owner = me then walk t ~goal ~level:place.level place.id []
  in
  Array.iteri (fun goal -> Option.iter (start goal)) met;
  let wanted = Array.fold_left (fun n place -> if Option.is_some place then n + 1 else n) 0 met in
  if me = 0 then while Hashtbl.length t.runs < wanted do Mesh.pump t.mesh (-1.) done;
  List.sort compare (Hashtbl.fold (fun goal choices runs -> (goal, choices) :: runs) t.runs [])
