open Scc_base
open Scc_data
open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_graph_search
open Scc_evaluate
open Scc_engine

type move = { step : Lts.step; leaf : int; takes_out : bool; deed : Ties.deed option }
type nature = { splits : bool; wait : Rat.t option }

type alone = {
  body : Catalogue.body;
  nature : nature;
  urgent : move list;
  weak : move list;
  rests : bool;
  boxes : Float_box.t array;
  line : Moving_boxes.t Later.t;
  mutable passed : Rat.t;
  mutable after : int;
}

(* What two do that collide. *)
type hit = { pair : int; moves : move list }

(* Which events, by their places in the list, have just happened. *)
module Marks = Scc_data.Numbering.Make (struct
    type t = int list

    let equal = List.equal Int.equal
    let hash = List.fold_left (fun h i -> (31 * h) + i + 1) 0
  end)

type t = {
  semantics : Semantics.t;
  afresh : Semantics.t;
  catalogue : Catalogue.t;
  events : Property.event list;
  marks : Marks.t;
  of_marks : Common.numbers;  (** those of other processes *)
  natures : nature option Growable.t;  (** of the first forms, where it has been asked for *)
  mutable waits : Rat.t list;  (** of them, each once: equal ones are the same *)
  nobody : alone;
  singles : alone Recent.t;
  hits : hit Recent.t;
}

let semantics t = t.semantics
let afresh t = t.afresh
let catalogue t = t.catalogue
let nobody t = t.nobody

(* Any place will do for a pair, but not the same for all pairs of one process. *)
let spread pair = pair lxor ((pair lsr 31) * 0x9E3779B1)

let create ~events ~time_seen ~memory semantics =
  let catalogue = Catalogue.create ~marked:(events <> []) ~time_seen ~memory (Semantics.model semantics) in
  let marks = Marks.create () in
  ignore (Marks.number marks []);
  let nobody =
    {
      body = Catalogue.no_body;
      nature = { splits = false; wait = None };
      urgent = [];
      weak = [];
      rests = true;
      boxes = [||];
      line = Later.make (fun () -> Moving_boxes.create 0);
      passed = Rat.zero;
      after = Catalogue.nobody;
    }
  in
  {
    semantics; catalogue; events;
    afresh = Semantics.without_memo semantics; marks; of_marks = Common.numbers (); nobody;
    natures = Growable.create ();
    waits = [];
    singles = Recent.create ~number:(fun a -> a.body.number) ~none:nobody ~most:memory;
    hits = Recent.create ~number:(fun h -> spread h.pair) ~none:{ pair = -1; moves = [] } ~most:memory;
  }

let text_of_mark events = String.concat " " (List.map string_of_int events)
let mark_of_text text = List.filter_map int_of_string_opt (String.split_on_char ' ' text)

let mark_of t events =
  Common.common t.of_marks (Marks.number t.marks events) (fun own -> text_of_mark (Marks.get t.marks own))

let events_of t mark =
  Marks.get t.marks (Common.own t.of_marks mark (fun text -> Marks.number t.marks (mark_of_text text)))

let share t table texts =
  Common.share t.of_marks table ~kind:4 ~base:(Marks.size t.marks);
  Catalogue.share t.catalogue table texts

let numbers_so_far t = Int.max (Marks.size t.marks) (Catalogue.numbers_so_far t.catalogue)

let network processes = State.make ~processes ~step:None ~time:None

let mark t ~source label =
  match t.events with
  | [] -> 0
  | _ :: _ ->
    let happened = List.mapi (fun i e -> if Event.matches ~source label e then Some i else None) t.events in
    mark_of t (List.filter_map Fun.id happened)

let has_events t = match t.events with [] -> false | _ :: _ -> true
let events t = t.events


let place t event =
  let rec from i = function
    | [] -> None
    | e :: rest -> if Formula.equal_event e event then Some i else from (i + 1) rest
  in
  from 0 t.events

(* What happens to some processes: they leave their slots, and others enter theirs. *)
let move t (o : Transition.outcome) =
  let slots = Hashtbl.create 8 in
  let leave p = Hashtbl.replace slots (Catalogue.first_leaf p) Catalogue.nobody in
  let enter p = Hashtbl.replace slots (Catalogue.first_leaf p) (Catalogue.process t.catalogue p) in
  List.iter leave o.gone;
  List.iter enter o.come;
  (match t.events with
   | [] -> ()
   | _ :: _ -> Hashtbl.replace slots (Catalogue.mark_slot t.catalogue) (mark t ~source:(network o.gone) o.label));
  let changes = Hashtbl.fold (fun slot v acc -> (slot, v) :: acc) slots [] in
  let in_order = List.sort (fun (i, _) (j, _) -> Int.compare i j) changes in
  {
    step =
      {
        label = Catalogue.label t.catalogue o.label;
        changes = Array.of_list (List.concat_map (fun (slot, v) -> [ slot; v ]) in_order);
      };
    leaf = Catalogue.first_leaf (List.hd o.gone);
    takes_out = o.come = [];
    deed =
      (if Model.draws_ties (Semantics.model t.semantics) && Transition.is_urgent o.label then Some (Ties.deed o)
       else None);
  }

let tied t (can : move Network.discrete) =
  if not (Model.draws_ties (Semantics.model t.semantics)) then can
  else
    let deeds = List.filter_map (fun m -> m.deed) in
    let odds = Ties.odds (deeds can.urgent @ deeds can.collisions) in
    let by_chance m =
      match Option.bind m.deed odds with
      | None -> m
      | Some chance ->
        let label = Catalogue.label_of t.catalogue m.step.label in
        { m with step = { m.step with label = Catalogue.tied t.catalogue label chance } }
    in
    { can with urgent = List.map by_chance can.urgent; collisions = List.map by_chance can.collisions }

(* {1 One process} *)

let shared t wait =
  match List.find_opt (Rat.equal wait) t.waits with
  | Some known -> known
  | None ->
    t.waits <- wait :: t.waits;
    wait

let look_at_form t p =
  let splits = Network.urgent t.afresh p <> [] || Splits.weak t.afresh p <> [] in
  { splits; wait = Option.map (shared t) (Time.wait (Semantics.model t.semantics) p) }

let nature t form =
  for _ = Growable.length t.natures to form do
    Growable.push t.natures None
  done;
  match Growable.get t.natures form with
  | Some nature -> nature
  | None ->
    let nature = look_at_form t (Catalogue.form t.catalogue form) in
    Growable.set t.natures form (Some nature);
    nature

(* The box about all comes first. *)
let line velocity boxes =
  let set line i box =
    Moving_boxes.set line i box ~at:Vec.zero ~velocity;
    Moving_boxes.set_until line i infinity
  in
  Later.make (fun () ->
      let line = Moving_boxes.create (1 + Array.length boxes) in
      set line 0 (Float_box.hull boxes);
      Array.iteri (fun i box -> set line (i + 1) box) boxes;
      line)

let look t number =
  let body = Catalogue.body t.catalogue number in
  let nature = nature t body.form in
  let moves splits = List.map (move t) (splits t.afresh body.process) in
  let parts = Collisions.parts t.afresh [| body.process |] in
  let boxes = Array.map (Neighbours.box ~margin:Rat.zero) parts in
  {
    body; nature;
    urgent = (if nature.splits then moves Network.urgent else []);
    weak = (if nature.splits then moves Network.weak else []);
    rests = Catalogue.resting t.catalogue body.velocity;
    boxes;
    line = line body.process.velocity boxes;
    passed = Rat.zero;
    after = number;
  }

let alone t number =
  let a = Recent.get t.singles number in
  if a.body.number = number then a
  else begin
    let a = look t number in
    Recent.keep t.singles a;
    a
  end

(* Nothing of it changes with time but its place. *)
let ageless a = Option.is_none a.nature.wait

let after t d a =
  if ageless a && a.rests then a.body.number
  else begin
    if not (d == a.passed || Rat.equal d a.passed) then begin
      a.after <-
        (if ageless a then Catalogue.displaced t.catalogue d a.body
         else
           Time.pass_process (Semantics.model t.semantics) d a.body.process
           |> Catalogue.process t.catalogue);
      a.passed <- d
    end;
    a.after
  end

(* {1 Two} *)

let collisions t a b =
  let pair = (a.body.number lsl 31) lor b.body.number in
  let h = Recent.get t.hits (spread pair) in
  if h.pair = pair then h.moves
  else begin
    let moves = List.map (move t) (Network.together t.afresh [| a.body.process; b.body.process |]) in
    Recent.keep t.hits { pair; moves };
    moves
  end
