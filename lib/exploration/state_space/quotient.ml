open Scc_data
open Scc_exact
open Scc_calculus
open Scc_property

type t = {
  symmetry : Symmetry.t;
  translation : bool;
  drift : Drift.t option;
  forgets : bool;
  isometries : Isometry.t list;
}

let none = { symmetry = Symmetry.none; translation = false; drift = None; forgets = false; isometries = [] }

let translatable (m : Model.t) (s : State.t) formulas =
  let stays (p : State.process) = Option.is_none (State.mass m p) in
  (not (Array.exists stays s.processes))
  && (not (Array.exists (fun (l : Model.leaf) -> Law.mentions_position l.law) m.leaves))
  && not (List.exists Formula.mentions_position formulas)

(** {1 Of the tuples of a catalogue} *)

type within = {
  quotient : t;
  catalogue : Catalogue.t;
  is_held : int -> bool;  (** {!Drift.is_held}, of the number of a process *)
  names : names Recent.t;
  images : image Recent.t array;  (** for each isometry *)
}

(* A process of one leaf, the leaf that it is renamed to, and its number then. *)
and names = { number : int; leaf : int; renamed : int }

(* A process, and its image. *)
and image = { original : int; there : int }

let place_of_name number leaf = (31 * number) + leaf
let no_names = { number = Catalogue.nobody; leaf = 0; renamed = Catalogue.nobody }
let no_image = { original = Catalogue.nobody; there = Catalogue.nobody }
let memory = 1 lsl 14

let within quotient catalogue =
  let is_held =
    match quotient.drift with
    | None -> fun _ -> true
    | Some d -> Catalogue.remembered catalogue false (Drift.is_held d)
  in
  let names = Recent.create ~number:(fun n -> place_of_name n.number n.leaf) ~none:no_names ~most:memory in
  let images _ = Recent.create ~number:(fun i -> i.original) ~none:no_image ~most:memory in
  { quotient; catalogue; is_held; names; images = Array.of_list (List.map images quotient.isometries) }

let renames w = not (Symmetry.is_none w.quotient.symmetry && w.quotient.isometries = [])
let process w number = (Catalogue.body w.catalogue number).process

let iter_present w f (tuple : int array) =
  for i = 0 to Array.length (Catalogue.model w.catalogue).leaves - 1 do
    let number = Array.unsafe_get tuple i in
    if number <> Catalogue.nobody then f number
  done

let iter_present_slots w f (tuple : int array) =
  for i = 0 to Array.length (Catalogue.model w.catalogue).leaves - 1 do
    if tuple.(i) <> Catalogue.nobody then f i tuple.(i)
  done

let fold_present w f acc (tuple : int array) =
  let rec from i acc =
    if i < 0 then acc else from (i - 1) (if tuple.(i) = Catalogue.nobody then acc else f i tuple.(i) acc)
  in
  from (Array.length (Catalogue.model w.catalogue).leaves - 1) acc

let present w tuple = fold_present w (fun slot _ slots -> slot :: slots) [] tuple
let processes w tuple = Array.of_list (fold_present w (fun _ number found -> process w number :: found) [] tuple)

(* The slot and the number of a process whose leaves have other names. *)
let renamed w image number =
  let p = process w number in
  match p.leaves with
  | [| { leaf; _ } |] when image leaf = leaf -> (leaf, number)
  | [| { leaf; _ } |] ->
    let leaf = image leaf in
    let known = Recent.get w.names (place_of_name number leaf) in
    if known.number = number && known.leaf = leaf then (leaf, known.renamed)
    else begin
      let names = { number; leaf; renamed = Catalogue.process w.catalogue (State.renamed image p) } in
      Recent.keep w.names names;
      (leaf, names.renamed)
    end
  | _ ->
    let p = State.renamed image p in
    (Catalogue.first_leaf p, Catalogue.process w.catalogue p)

let sorted w tuple =
  let symmetry = w.quotient.symmetry in
  if Symmetry.is_none symmetry then tuple
  else
    let each place = iter_present w (fun number -> place (process w number)) tuple in
    match Symmetry.canonical symmetry each with
    | None -> tuple
    | Some image ->
      let copy = Array.copy tuple in
      Array.fill copy 0 (Array.length (Catalogue.model w.catalogue).leaves) Catalogue.nobody;
      let put number =
        let slot, number = renamed w image number in
        copy.(slot) <- number
      in
      iter_present w put tuple;
      copy

(** {2 Isometries} *)

let image_of w images g number =
  let known = Recent.get images number in
  if known.original = number then known.there
  else begin
    let image = Isometry.image g (Catalogue.model w.catalogue) (process w number) in
    let found = { original = number; there = Catalogue.process w.catalogue image } in
    Recent.keep images found;
    found.there
  end

(* By the places in the order of slots, and then by velocities, so that the order does not depend on numbers. *)
let compare_tuples w a b =
  let places (p : State.process) = p.leaves.(0).position and velocity (p : State.process) = p.velocity in
  let drawn (p : State.process) =
    match p.draw with Some (Drawn g) -> g.velocity | Some Waits | None -> Vec.zero
  in
  let rec by value i =
    if i = Array.length (Catalogue.model w.catalogue).leaves then 0
    else if a.(i) = b.(i) then by value (i + 1)
    else if a.(i) = Catalogue.nobody then 1
    else if b.(i) = Catalogue.nobody then -1
    else
      match Vec.compare (value (process w a.(i))) (value (process w b.(i))) with
      | 0 -> by value (i + 1)
      | order -> order
  in
  match by places 0 with 0 -> (match by velocity 0 with 0 -> by drawn 0 | order -> order) | order -> order

(* The first of the images in order. *)
let turned w tuple =
  let first = ref (sorted w tuple) in
  let look i g =
    let copy = Array.copy tuple in
    iter_present_slots w (fun slot number -> copy.(slot) <- image_of w w.images.(i) g number) tuple;
    let image = sorted w copy in
    if compare_tuples w image !first < 0 then first := image
  in
  List.iteri look w.quotient.isometries;
  !first

(* The first leaf comes to the origin. *)
let centred w tuple =
  if not w.quotient.translation then tuple
  else
    match present w tuple with
    | [] -> tuple
    | first :: _ as slots ->
      let place = (process w tuple.(first)).leaves.(0).position in
      if Vec.is_zero place then tuple
      else begin
        let copy = Array.copy tuple in
        let by = Vec.neg place in
        List.iter (fun slot -> copy.(slot) <- Catalogue.shifted w.catalogue by tuple.(slot)) slots;
        copy
      end

(* Each group that meets nobody else any more is moved to where it would be alone. *)
let apart w d tuple =
  if fold_present w (fun _ number inside -> inside && w.is_held number) true tuple then None
  else
    match Drift.place d (processes w tuple) with
    | [] -> None
    | shifts ->
      let copy = Array.copy tuple and slots = Array.of_list (present w tuple) in
      let shift (i, by) =
        if not (Vec.is_zero by) then copy.(slots.(i)) <- Catalogue.shifted w.catalogue by tuple.(slots.(i))
      in
      List.iter shift shifts;
      Some copy

(* The next velocity of a process, or of what it is a piece of, does not depend on the one that it has. *)
let is_lost (m : Model.t) (p : State.process) =
  let is_velocity : Law.variable -> bool = function
    | Vx | Vy | Vz -> true
    | X | Y | Z | Wx | Wy | Wz | Mass | Time | Dt -> false
  in
  let reads_no_velocity (l : State.leaf) =
    let law = m.leaves.(l.leaf).law in
    (not (Law.is_inertial law))
    && not (Law.mentions is_velocity law)
  in
  Array.for_all reads_no_velocity p.leaves

(* Where several wait to draw, those whose laws do not read it lose the velocity that they are about to lose. *)
let forgotten w tuple =
  if not w.quotient.forgets then tuple
  else
    let body number = Catalogue.body w.catalogue number in
    let add slot number found =
      match (body number).process.draw with Some Waits -> (slot, number) :: found | Some (Drawn _) | None -> found
    in
    match fold_present w add [] tuple with
    | [] | [ _ ] -> tuple
    | waiting ->
      let forget slots (slot, number) =
        let { Catalogue.velocity; process; _ } = body number in
        if Catalogue.resting w.catalogue velocity || not (is_lost (Catalogue.model w.catalogue) process) then slots
        else (slot, Catalogue.process w.catalogue (State.with_velocity Vec.zero process)) :: slots
      in
      (match List.fold_left forget [] waiting with
       | [] -> tuple
       | changes ->
         let copy = Array.copy tuple in
         List.iter (fun (slot, number) -> copy.(slot) <- number) changes;
         copy)

(* To place groups and to rename leaves by their places is one in any order; places count after that. *)
let representative w tuple =
  let tuple = forgotten w tuple in
  match Option.bind w.quotient.drift (fun d -> apart w d tuple) with
  | Some placed -> sorted w placed
  | None -> centred w (turned w tuple)

let same_but_for_places w one two =
  match w.quotient.drift with
  | None -> false
  | Some d -> (
      match (apart w d one, apart w d two) with
      | Some a, Some b -> a = b
      | None, _ | _, None -> false)

let keeps w tuple quantity =
  match w.quotient.drift with
  | None -> true
  | Some d -> Drift.keeps d (processes w tuple) quantity

let is_none w =
  let q = w.quotient in
  Symmetry.is_none q.symmetry
  && (not q.translation)
  && Option.is_none q.drift
  && (not q.forgets)
  && q.isometries = []
