open Scc_base
open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_runs

type t = { semantics : Semantics.t; model : Model.t; tolerance : Rat.t; index : (string, int) Hashtbl.t }

let make semantics ~tolerance =
  let model = Semantics.model semantics in
  let index = Hashtbl.create (Array.length model.leaves) in
  Array.iteri (fun i (l : Model.leaf) -> Hashtbl.replace index l.name i) model.leaves;
  { semantics; model; tolerance; index }

let semantics t = t.semantics
let model t = t.model
let tolerance t = t.tolerance
let leaf t name = Hashtbl.find_opt t.index name

(* {1 Names} *)

(* The features of a leaf by their names in labels, and the leaf. *)
let features_of (m : Model.t) leaf =
  let of_part index (part : Model.part) =
    let p = part.solid.Solid.polyhedron in
    let named feature = Recorded.normal (Model.site_name m ~leaf { Site.part = index; feature }) in
    let count n make = List.init n (fun i -> named (make i)) in
    count (Array.length p.vertices) (fun i -> Feature.Vertex i)
    @ count (Array.length p.edges) (fun i -> Feature.Edge i)
    @ count (Array.length p.faces) (fun i -> Feature.Face i)
  in
  List.concat (List.mapi of_part (Array.to_list m.leaves.(leaf).parts))

(* The longest name of a leaf that a feature's name begins with. *)
let owner t feature =
  let rec before i =
    match if i <= 0 then None else String.rindex_from_opt feature (i - 1) '.' with
    | None -> None
    | Some dot -> (
        match leaf t (String.sub feature 0 dot) with Some l -> Some l | None -> before dot)
  in
  before (String.length feature)

let most_faults = 20

let names t (trace : Recorded.t) =
  let known = Hashtbl.create 16 in
  let has leaf feature =
    let all =
      match Hashtbl.find_opt known leaf with
      | Some all -> all
      | None ->
        let all = features_of t.model leaf in
        Hashtbl.add known leaf all;
        all
    in
    if List.exists (String.equal feature) all then None else Some all
  in
  let bodies = lazy (List.map (fun (l : Model.leaf) -> l.name) (Array.to_list t.model.leaves)) in
  let no_body at name =
    Diag.error Code.bad_trace at ?hint:(Diag.suggest name (Lazy.force bodies)) "the model has no body `%s`" name
  in
  let body at name = if Option.is_some (leaf t name) then [] else [ no_body at name ] in
  let feature at name =
    match owner t name with
    | None -> [ no_body at (match String.index_opt name '.' with Some i -> String.sub name 0 i | None -> name) ]
    | Some l -> (
        match has l name with
        | None -> []
        | Some all ->
          [
            Diag.error Code.bad_trace at ?hint:(Diag.suggest name all) "the model has no feature `%s`" name;
          ])
  in
  let of_item (i : Recorded.item) =
    match i.what with
    | Event e -> List.concat_map (body i.at) e.bodies @ List.concat_map (feature i.at) e.features
    | State (bodies, _) ->
      List.concat (List.map (fun (b : Recorded.body) -> body i.at b.name) bodies)
    | Watched | Quiescent | Stuck -> []
  in
  let add faults i = if List.length faults >= most_faults then faults else faults @ of_item i in
  Array.fold_left add [] trace.items |> List.filteri (fun i _ -> i < most_faults)

(* {1 Events} *)

let distinct l = List.sort_uniq Int.compare l

let leaves t (e : Recorded.event) =
  distinct (List.filter_map (leaf t) e.bodies @ List.filter_map (owner t) e.features)

(* The first leaf of the process that has a leaf. *)
let first_of s leaf = Option.map (fun (p : State.process) -> p.leaves.(0).leaf) (State.home s leaf)

let processes_of t s e =
  distinct (List.filter_map (first_of s) (leaves t e))

let kind : Transition.label -> Recorded.kind option = function
  | Time _ | Lot _ -> None
  | Bind _ -> Some Bind
  | Close _ -> Some Close
  | Bounce _ -> Some Bounce
  | Absorb _ -> Some Absorb
  | Weak_split _ -> Some Weak
  | Strong_split _ -> Some Strong
  | Draw _ -> Some Draw

let ends (b : State.bond) = [ b.one; b.two ]

let label_features t label =
  let named (f : State.finish) = Recorded.normal (Model.site_name t.model ~leaf:f.at f.site) in
  Recorded.sort (List.map named (List.concat_map ends (Transition.bonds label)))

(* One sorted list in another, each as often. *)
let rec within xs ys =
  match (xs, ys) with
  | [], _ -> true
  | _ :: _, [] -> false
  | x :: xs', y :: ys' ->
    let c = String.compare x y in
    if c = 0 then within xs' ys' else c > 0 && within xs ys'

(* Of a bounce, or who is absorbed by whom: whether there is one leaf of each of the processes. *)
let between s mine firsts =
  let told first =
    match State.home s first with Some p -> List.exists (State.has_leaf p) mine | None -> false
  in
  List.compare_lengths mine firsts = 0 && List.for_all told firsts

let same_bodies t s e (label : Transition.label) =
  let mine = leaves t e in
  match label with
  | Time _ | Lot _ -> false
  | Bounce { firsts; _ } -> between s mine firsts
  | Absorb { first; absorber } -> between s mine [ first; absorber ]
  | Draw { first; _ } -> between s mine [ first ]
  | Bind b when e.kind = Bounce || e.kind = Absorb -> between s mine [ b.one.at; b.two.at ]
  | Bind _ | Close _ | Weak_split _ | Strong_split _ ->
    let finishes = List.concat_map ends (Transition.bonds label) in
    let theirs = distinct (List.map (fun (f : State.finish) -> f.at) finishes) in
    let told = distinct (List.filter_map (leaf t) e.bodies) in
    if e.bodies <> [] then List.equal Int.equal told theirs
    else List.for_all (fun l -> List.mem l theirs) mine

let same_channels (e : Recorded.event) label =
  e.channels = []
  || List.equal String.equal e.channels
    (List.sort_uniq String.compare (List.map (fun (b : State.bond) -> b.name) (Transition.bonds label)))

(* Each bond that is told with its ends is one of these: the names and the ends by themselves do not tell which
   belong together. *)
let same_bonds t (e : Recorded.event) label =
  let texts (b : State.bond) =
    let named (f : State.finish) = Recorded.normal (Model.site_name t.model ~leaf:f.at f.site) in
    List.map (fun name -> Recorded.bond_text name (List.map named (ends b))) [ b.name; "" ]
  in
  let theirs = lazy (List.concat_map texts (Transition.bonds label)) in
  List.for_all (fun told -> List.exists (String.equal told) (Lazy.force theirs)) e.together

(* A bond has both its ends told, or one, or none; a reaction all or none. *)
let same_features t (e : Recorded.event) label =
  let theirs = label_features t label in
  same_bonds t e label
  &&
  match e.kind with
  | Bounce | Absorb | Draw -> true
  | Bind | Close | Weak -> within e.features theirs
  | Strong -> e.features = [] || List.equal String.equal e.features theirs

let common_body t s e label =
  let theirs =
    match (label : Transition.label) with
    | Bounce { firsts; _ } -> firsts
    | Absorb { first; absorber } -> [ first; absorber ]
    | Draw { first; _ } -> [ first ]
    | _ ->
      let finishes = List.concat_map ends (Transition.bonds label) in
      List.filter_map (fun (f : State.finish) -> first_of s f.at) finishes
  in
  List.exists (fun p -> List.mem p theirs) (processes_of t s e)

let same_motion t (e : Recorded.event) (label : Transition.label) =
  let off x y = Rat.compare (Rat.abs (Rat.sub x y)) t.tolerance > 0 in
  let same (told : Vec.t option) (mine : Vec.t option) =
    match (told, mine) with
    | Some a, Some b -> not (off a.x b.x || off a.y b.y || off a.z b.z)
    | Some _, None -> false
    | None, _ -> true
  in
  match label with
  | Draw { given; _ } -> same e.velocity (Some given.velocity) && same e.spin given.spin
  | _ -> true

type nearness = Same | Other_motion | Other_features | Other_channel | Other_kind | Other_partner | Unlike

let nearness t s (e : Recorded.event) label =
  match kind label with
  | None -> Unlike
  | Some k ->
    let same_kind = k = e.kind in
    if same_bodies t s e label then
      if not same_kind then Other_kind
      else if not (same_motion t e label) then Other_motion
      else if not (same_channels e label) then Other_channel
      else if same_features t e label then Same
      else Other_features
    else if same_kind && common_body t s e label then Other_partner
    else Unlike

let matches t s e label = nearness t s e label = Same

(* {1 States} *)

type difference = {
  body : string;
  quantity : string;
  told : string;
  held : string;
  off : Rat.t option;
}

type deviation = { time : Rat.t; position : Rat.t; velocity : Rat.t }

let no_deviation = { time = Rat.zero; position = Rat.zero; velocity = Rat.zero }

let later a b =
  {
    time = Rat.max a.time b.time;
    position = Rat.max a.position b.position;
    velocity = Rat.max a.velocity b.velocity;
  }

let coordinate (v : Vec.t) = function 0 -> v.x | 1 -> v.y | _ -> v.z

let held_number (p : State.process) (l : State.leaf) : Recorded.quantity -> Rat.t = function
  | Position i -> coordinate l.position i
  | Velocity i -> coordinate p.velocity i
  | Spin i -> coordinate p.spin i

let close t a b = Rat.compare (Rat.abs (Rat.sub a b)) t.tolerance <= 0
let of_text body quantity ~told ~held = { body; quantity; told; held; off = None }

let of_number body quantity ~told ~held =
  { body; quantity; told = Rat.to_string told; held = Rat.to_string held; off = Some (Rat.sub told held) }

let number t p l (b : Recorded.body) (quantity, told) =
  let held = held_number p l quantity in
  if close t told held then [] else [ of_number b.name (Recorded.quantity_text quantity) ~told ~held ]

(* Clocks run in a circle: just before a split instant is close to it. *)
let clock t (p : State.process) (b : Recorded.body) =
  match (b.clock, p.clock) with
  | None, _ | Some None, None -> []
  | Some (Some told), Some held ->
    let off = Rat.abs (Rat.sub told held) in
    let off =
      match t.model.splits with
      | Every step -> Rat.min off (Rat.abs (Rat.sub step off))
      | Any_time -> off
    in
    if Rat.compare off t.tolerance <= 0 then [] else [ of_number b.name "clock" ~told ~held ]
  | Some told, held ->
    let show = function None -> "none" | Some c -> Rat.to_string c in
    [ of_text b.name "clock" ~told:(show told) ~held:(show held) ]

let texts b quantity told held =
  match told with
  | Some told when not (String.equal told held) -> [ of_text b quantity ~told ~held ]
  | Some _ | None -> []

let lists b quantity told held =
  let show = String.concat ", " in
  match told with
  | Some told when not (List.equal String.equal told held) ->
    [ of_text b quantity ~told:("{" ^ show told ^ "}") ~held:("{" ^ show held ^ "}") ]
  | Some _ | None -> []

let group t (p : State.process) =
  Recorded.sort (List.map (fun (l : State.leaf) -> t.model.leaves.(l.leaf).name) (Array.to_list p.leaves))

let bonds_of t (p : State.process) =
  let text (b : State.bond) =
    let named (f : State.finish) = Recorded.normal (Model.site_name t.model ~leaf:f.at f.site) in
    Recorded.bond_text b.name (List.map named (ends b))
  in
  Recorded.sort (List.map text (Array.to_list p.bonds))

(* Orientations as matrices, so that the length of the quaternion and its sign do not matter. *)
let turned t (l : State.leaf) (b : Recorded.body) =
  match Option.bind b.turned (fun (w, v) -> Mat.of_quaternion (w, v.Vec.x, v.y, v.z)) with
  | None -> []
  | Some told ->
    let held = Quaternion.to_mat l.turned in
    let row r = List.map (coordinate r) [ 0; 1; 2 ] in
    let entries (m : Mat.t) = List.concat_map row [ m.r0; m.r1; m.r2 ] in
    let off = List.map2 (fun a b -> Rat.abs (Rat.sub a b)) (entries told) (entries held) in
    let most = List.fold_left Rat.max Rat.zero off in
    if Rat.compare most t.tolerance <= 0 then []
    else
      let w, v = Option.get b.turned in
      [
        {
          body = b.name; quantity = "turned"; told = Rat.to_string w ^ " " ^ Vec.to_string v;
          held = Quaternion.to_string l.turned; off = Some most;
        };
      ]

let origin t (l : State.leaf) (b : Recorded.body) =
  let held = Option.map (fun k -> t.model.definitions.(k).name) l.behaviour.origin in
  match b.origin with
  | Some told when not (Option.equal String.equal told held) ->
    let show = Option.value ~default:"none" in
    [ of_text b.name "origin" ~told:(show told) ~held:(show held) ]
  | Some _ | None -> []

let of_present t (p : State.process) (b : Recorded.body) index =
  let l = State.leaf_of p index in
  lists b.name "process" b.group (group t p)
  @ lists b.name "bonds" b.bonds (bonds_of t p)
  @ List.concat_map (number t p l b) b.numbers
  @ turned t l b
  @ texts b.name "behaviour" b.behaviour (State_json.behaviour t.model ~leaf:index l.behaviour)
  @ origin t l b
  @ clock t p b

let of_body t s (b : Recorded.body) index =
  match State.home s index with
  | Some _ when b.gone -> [ of_text b.name "presence" ~told:"gone" ~held:"there" ]
  | Some p -> of_present t p b index
  | None when b.gone -> []
  | None -> [ of_text b.name "presence" ~told:"there" ~held:"gone" ]

let spread (p : State.process) (b : Recorded.body) index =
  let l = State.leaf_of p index in
  let add d ((quantity : Recorded.quantity), told) =
    let off = Rat.abs (Rat.sub told (held_number p l quantity)) in
    match quantity with
    | Position _ -> { d with position = Rat.max d.position off }
    | Velocity _ -> { d with velocity = Rat.max d.velocity off }
    | Spin _ -> d
  in
  List.fold_left add no_deviation b.numbers

let phase : State.phase -> string = function Moving -> "moving" | Due -> "due" | Steered -> "steered"

(* Where a step stands is compared exactly, or not at all: its end is an instant like any other. *)
let step t (s : State.t) (told : Recorded.step option) =
  match (told, s.step) with
  | Some told, Some held when Rat.sign t.tolerance = 0 ->
    (if Rat.equal told.remaining held.remaining then []
     else [ of_number "" "step" ~told:told.remaining ~held:held.remaining ])
    @ texts "" "phase" (Some told.phase) (phase held.phase)
  | _ -> []

let body t s (b : Recorded.body) =
  match leaf t b.name with
  | None -> ([], no_deviation)
  | Some index ->
    let off p = spread p b index in
    (of_body t s b index, Option.fold ~none:no_deviation ~some:off (State.home s index))

let differences t s bodies told_step =
  let add (found, deviation) b =
    let differences, off = body t s b in
    (List.rev_append differences found, later deviation off)
  in
  let found, deviation = List.fold_left add ([], no_deviation) bodies in
  (List.rev_append found (step t s told_step), deviation)
