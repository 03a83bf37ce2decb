open Scc_exact
open Scc_geometry
open Scc_calculus

let version = 1

type t = { model : Model.t; terms : Term_numbers.t }

let make model initial = { model; terms = Term_numbers.make model initial }
let malformed what = raise (Packed.Malformed what)

(* {1 What is there} *)

(* Bits of the first number of a process. *)
let has_clock = 1
let has_phase = 2
let has_draw = 4
let has_lots = 8
let has_turn = 16
let has_turned = 32
let has_waited = 64
let all_parts = 127

let turns (p : State.process) =
  let ends_at_once = match p.lasts with Some d -> Rat.sign d = 0 | None -> false in
  not (Vec.is_zero p.spin && Rat.sign p.since = 0 && ends_at_once && Vec.is_zero p.kept)

let parts (p : State.process) =
  let bit mask present = if present then mask else 0 in
  let some test = Array.exists test p.leaves in
  bit has_clock (Option.is_some p.clock)
  lor bit has_phase (Option.is_some p.phase)
  lor bit has_draw (Option.is_some p.draw)
  lor bit has_lots (Option.is_some p.lots)
  lor bit has_turn (turns p)
  lor bit has_turned (some (fun (l : State.leaf) -> not (Quaternion.is_identity l.turned)))
  lor bit has_waited (some (fun (l : State.leaf) -> Rat.sign l.waited <> 0))

let has mask parts = parts land mask <> 0

(* {1 Writing} *)

let put_feature buffer (f : Feature.t) =
  let index = match f with Vertex i | Edge i | Face i -> i in
  Packed.put_nat buffer ((3 * index) + Feature.dimension f)

let put_finish buffer (f : State.finish) =
  Packed.put_nat buffer f.at;
  Packed.put_nat buffer f.site.part;
  put_feature buffer f.site.feature

let put_bond t buffer (b : State.bond) =
  Term_numbers.put_name t.terms buffer b.name;
  put_finish buffer b.one;
  put_finish buffer b.two

let put_leaf t parts buffer (l : State.leaf) =
  Packed.put_nat buffer l.leaf;
  Packed.put_vector buffer l.position;
  if has has_turned parts then
    List.iter (Packed.put_integer buffer) [ l.turned.w; l.turned.x; l.turned.y; l.turned.z ];
  if has has_waited parts then Packed.put_rational buffer l.waited;
  Packed.put_nat buffer (match l.behaviour.origin with None -> 0 | Some k -> k + 1);
  Term_numbers.put t.terms buffer l.behaviour.term

let put_phase buffer (p : State.phase) =
  Packed.put_nat buffer (match p with Moving -> 0 | Due -> 1 | Steered -> 2)

let put_draw buffer (d : State.draw) =
  match d with
  | Waits -> Packed.put_nat buffer 0
  | Drawn { velocity; spin = None } ->
    Packed.put_nat buffer 1;
    Packed.put_vector buffer velocity
  | Drawn { velocity; spin = Some spin } ->
    Packed.put_nat buffer 2;
    Packed.put_vector buffer velocity;
    Packed.put_vector buffer spin

let put_pending t buffer ((bond, lot) : State.bond * State.lot) =
  let drawn number list =
    Packed.put_nat buffer number;
    let one buffer (leaf, term) =
      Packed.put_nat buffer leaf;
      Term_numbers.put t.terms buffer term
    in
    Packed.put_list buffer one list
  in
  put_bond t buffer bond;
  match lot with
  | Undecided -> Packed.put_nat buffer 0
  | Let_go list -> drawn 1 list
  | Next list -> drawn 2 list

let put_lots t buffer (l : State.lots) =
  Packed.put_rational buffer l.since;
  Packed.put_list buffer (put_pending t) l.pending

let put_process t buffer (p : State.process) =
  let parts = parts p in
  Packed.put_nat buffer parts;
  Packed.put_list buffer (put_leaf t parts) (Array.to_list p.leaves);
  Packed.put_list buffer (put_bond t) (Array.to_list p.bonds);
  Packed.put_vector buffer p.velocity;
  if has has_turn parts then (
    Packed.put_vector buffer p.spin;
    Packed.put_rational buffer p.since;
    Packed.put_list buffer Packed.put_rational (Option.to_list p.lasts);
    Packed.put_vector buffer p.kept);
  Option.iter (Packed.put_rational buffer) p.clock;
  Option.iter (put_phase buffer) p.phase;
  Option.iter (put_draw buffer) p.draw;
  Option.iter (put_lots t buffer) p.lots

let put_step buffer (step : State.step) =
  Packed.put_rational buffer step.remaining;
  put_phase buffer step.phase

let put_head buffer count =
  Packed.put_nat buffer version;
  Packed.put_nat buffer count

let put_rest buffer ~step ~time =
  Packed.put_list buffer put_step (Option.to_list step);
  Packed.put_list buffer Packed.put_rational (Option.to_list time)

let encode t (s : State.t) =
  let buffer = Buffer.create 256 in
  put_head buffer (Array.length s.processes);
  Array.iter (put_process t buffer) s.processes;
  put_rest buffer ~step:s.step ~time:s.time;
  Buffer.contents buffer

(* {1 Reading} *)

let option source read =
  match Packed.list source read with
  | [] -> None
  | [ x ] -> Some x
  | _ -> malformed "there are several where one may be"

let feature (polyhedron : Polyhedron.t) source : Feature.t =
  let n = Packed.nat source in
  let index count = if n / 3 < count then n / 3 else malformed (Printf.sprintf "feature %d is not there" n) in
  match n mod 3 with
  | 0 -> Vertex (index (Array.length polyhedron.vertices))
  | 1 -> Edge (index (Array.length polyhedron.edges))
  | _ -> Face (index (Array.length polyhedron.faces))

let leaf_number t source = Packed.below (Array.length t.model.leaves) ~what:"the body" source

let finish t source : State.finish =
  let at = leaf_number t source in
  let parts = t.model.leaves.(at).parts in
  let part = Packed.below (Array.length parts) ~what:"the part" source in
  { at; site = { part; feature = feature parts.(part).solid.polyhedron source } }

let bond t source =
  let name = Term_numbers.read_name t.terms source in
  let one = finish t source in
  let two = finish t source in
  State.bond name one two

let turned source =
  let w = Packed.integer source in
  let x = Packed.integer source in
  let y = Packed.integer source in
  let z = Packed.integer source in
  if List.for_all (fun c -> Z.sign c = 0) [ w; x; y; z ] then malformed "the quaternion 0 is no rotation"
  else Quaternion.make w x y z

let leaf t parts source : State.leaf =
  let leaf = leaf_number t source in
  let position = Packed.vector source in
  let turned = if has has_turned parts then turned source else Quaternion.identity in
  let waited = if has has_waited parts then Packed.rational source else Rat.zero in
  let origin = Packed.below (Array.length t.model.definitions + 1) ~what:"the definition" source in
  let term = Term_numbers.read t.terms source in
  let behaviour = Behaviour.aged (if origin = 0 then None else Some (origin - 1)) term in
  { leaf; position; turned; waited; behaviour }

let phase source : State.phase =
  match Packed.below 3 ~what:"the phase" source with 0 -> Moving | 1 -> Due | _ -> Steered

let draw source : State.draw =
  match Packed.below 3 ~what:"the draw" source with
  | 0 -> Waits
  | kind ->
    let velocity = Packed.vector source in
    Drawn { velocity; spin = (if kind = 1 then None else Some (Packed.vector source)) }

let pending t source =
  let bond = bond t source in
  let drawn () =
    Packed.list source (fun source ->
        let leaf = leaf_number t source in
        (leaf, Term_numbers.read t.terms source))
  in
  let lot : State.lot =
    match Packed.below 3 ~what:"the lot" source with
    | 0 -> Undecided
    | 1 -> Let_go (drawn ())
    | _ -> Next (drawn ())
  in
  (bond, lot)

let lots t source : State.lots =
  let since = Packed.rational source in
  { since; pending = Packed.list source (pending t) }

let process t source =
  let parts = Packed.below (all_parts + 1) ~what:"the kind of process" source in
  let leaves = Packed.list source (leaf t parts) in
  let bonds = Packed.list source (bond t) in
  let velocity = Packed.vector source in
  let spin, since, lasts, kept =
    if not (has has_turn parts) then (Vec.zero, Rat.zero, Some Rat.zero, Vec.zero)
    else
      let spin = Packed.vector source in
      let since = Packed.rational source in
      let lasts = option source Packed.rational in
      (spin, since, lasts, Packed.vector source)
  in
  let part mask read = if has mask parts then Some (read source) else None in
  let clock = part has_clock Packed.rational in
  let phase = part has_phase phase in
  let draw = part has_draw draw in
  let lots = part has_lots (lots t) in
  let own at = List.exists (fun (l : State.leaf) -> l.leaf = at) leaves in
  if leaves = [] then malformed "a process has no bodies";
  if List.length bonds < List.length leaves - 1 then malformed "a process does not hang together";
  if not (List.for_all (fun (b : State.bond) -> own b.one.at && own b.two.at) bonds) then
    malformed "a bond ends at a body of another process";
  State.process ?phase ?draw ?lots ~spin ~since ~lasts ~kept ~leaves ~bonds ~velocity ~clock ()

let step source : State.step =
  let remaining = Packed.rational source in
  { remaining; phase = phase source }

let read_version source =
  let v = Packed.nat source in
  if v <> version then malformed (Printf.sprintf "it is of version %d, and %d is read" v version)

let read_head source =
  read_version source;
  Packed.nat source

let read_rest source =
  let step = option source step in
  (step, option source Packed.rational)

(* Lists that are not in order, a part that is told and need not be, a behaviour that has a number. *)
let in_form written text x =
  if String.equal written text then x else malformed "it is not in the form that each state has"

let read_process t text ~from =
  let source = Packed.source ~from text in
  let p = process t source in
  let next = Packed.place source in
  let buffer = Buffer.create 64 in
  put_process t buffer p;
  in_form (Buffer.contents buffer) (String.sub text from (next - from)) (p, next)

let decode t text =
  let source = Packed.source text in
  let read () =
    read_version source;
    let processes = Packed.list source (process t) in
    let step, time = read_rest source in
    if not (Packed.at_end source) then malformed "there is more than a state";
    let state = State.make ~processes ~step ~time in
    in_form (encode t state) text state
  in
  match read () with state -> Ok state | exception Packed.Malformed what -> Error what
