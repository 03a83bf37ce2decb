open Scc_data
open Scc_exact
open Scc_rigid

type leaf = {
  leaf : int;
  position : Vec.t;
  turned : Quaternion.t;
  waited : Rat.t;
  behaviour : Behaviour.aged;
}
type finish = { at : int; site : Site.t }
type bond = { name : string; one : finish; two : finish }

let compare_finish a b = Int.compare a.at b.at <?> fun () -> Site.compare a.site b.site

let compare_bond (a : bond) (b : bond) =
  compare_finish a.one b.one <?> fun () ->
    compare_finish a.two b.two <?> fun () -> String.compare a.name b.name

let equal_bond a b = compare_bond a b = 0
let bond name a b = if compare_finish a b <= 0 then { name; one = a; two = b } else { name; one = b; two = a }

type phase = Moving | Due | Steered
type draw = Waits | Drawn of Given.t

type drawn = (int * Behaviour.t) list
type lot = Undecided | Let_go of drawn | Next of drawn
type lots = { since : Rat.t; pending : (bond * lot) list }

type process = {
  leaves : leaf array;
  bonds : bond array;
  velocity : Vec.t;
  spin : Vec.t;
  since : Rat.t;
  lasts : Rat.t option;
  kept : Vec.t;
  clock : Rat.t option;
  phase : phase option;
  draw : draw option;
  lots : lots option;
}

type step = { remaining : Rat.t; phase : phase }
type t = { processes : process array; step : step option; time : Rat.t option }

let sorted compare list =
  let a = Scc_data.Long_array.of_list list in
  let rec in_order i = i >= Array.length a || (compare a.(i - 1) a.(i) <= 0 && in_order (i + 1)) in
  if not (in_order 1) then Array.stable_sort compare a;
  a

let compare_leaf_index (a : leaf) (b : leaf) = Int.compare a.leaf b.leaf

let no_turn = Some Rat.zero

let process ?phase ?draw ?lots ?(spin = Vec.zero) ?(since = Rat.zero) ?(lasts = no_turn) ?(kept = Vec.zero) ~leaves
    ~bonds ~velocity ~clock () =
  if List.length bonds < List.length leaves - 1 then
    Scc_base.Bug.fail __POS__ "a process that does not hang together";
  {
    leaves = sorted compare_leaf_index leaves;
    bonds = sorted compare_bond bonds;
    velocity; spin; since; lasts; kept; clock; phase; draw; lots;
  }

let compare_choice (i, b) (j, c) = Int.compare i j <?> fun () -> Behaviour.compare b c

let lot_rank = function Undecided -> 0 | Let_go _ -> 1 | Next _ -> 2

let compare_lot a b =
  match (a, b) with
  | Let_go c, Let_go d | Next c, Next d -> List.compare compare_choice c d
  | _ -> Int.compare (lot_rank a) (lot_rank b)

let compare_pending (b, l) (c, m) = compare_bond b c <?> fun () -> compare_lot l m

let renamed_lot image lot =
  let renamed drawn = List.sort compare_choice (List.map (fun (leaf, summand) -> (image leaf, summand)) drawn) in
  match lot with
  | Undecided -> Undecided
  | Let_go drawn -> Let_go (renamed drawn)
  | Next drawn -> Next (renamed drawn)

let map_leaves f p = { p with leaves = Array.map f p.leaves }

let renamed image (p : process) =
  let finish (f : finish) = { f with at = image f.at } in
  let renamed_bond (b : bond) = bond b.name (finish b.one) (finish b.two) in
  let leaf (l : leaf) = { l with leaf = image l.leaf } in
  let lots ({ since; pending } : lots) =
    let one (b, lot) = (renamed_bond b, renamed_lot image lot) in
    { since; pending = List.sort compare_pending (List.map one pending) }
  in
  process
    ~leaves:(List.map leaf (Array.to_list p.leaves))
    ~bonds:(List.map renamed_bond (Array.to_list p.bonds))
    ?phase:p.phase ?draw:p.draw ?lots:(Option.map lots p.lots) ~velocity:p.velocity ~spin:p.spin
    ~since:p.since ~lasts:p.lasts ~kept:p.kept
    ~clock:p.clock ()

let with_velocity velocity p = { p with velocity }
let with_turn ~spin ~since ~lasts p = { p with spin; since; lasts }
let with_kept kept p = { p with kept }
let with_clock clock p = { p with clock }
let with_bond b p = { p with bonds = sorted compare_bond (b :: Array.to_list p.bonds) }
let with_phase phase (p : process) = { p with phase }
let with_draw draw p = { p with draw }
let with_lots lots p = { p with lots }
let first p = p.leaves.(0).leaf

let compare_first p q = Int.compare (first p) (first q)
let make ~processes ~step ~time = { processes = sorted compare_first processes; step; time }
let mapi f (s : t) =
  { s with processes = Scc_data.Long_array.init (Array.length s.processes) (fun i -> f i s.processes.(i)) }

let restricted (s : t) stays =
  make ~processes:(List.filteri (fun i _ -> stays i) (Array.to_list s.processes)) ~step:s.step ~time:s.time

let members p = List.map (fun l -> l.leaf) (Array.to_list p.leaves)
let leaves (s : t) = List.concat_map (fun p -> Array.to_list p.leaves) (Array.to_list s.processes)
let bonds (s : t) = List.concat_map (fun p -> Array.to_list p.bonds) (Array.to_list s.processes)

let by_leaf (s : t) =
  let of_process p = List.map (fun l -> (p, l)) (Array.to_list p.leaves) in
  List.concat_map of_process (Array.to_list s.processes)
  |> List.sort (fun (_, l) (_, k) -> Int.compare l.leaf k.leaf)

let at ~step ~time (s : t) = { s with step; time }

let exchange ~gone ~come (s : t) =
  let rec from i come before =
    if i = Array.length s.processes then List.rev_append before come
    else
      let p = s.processes.(i) in
      match come with
      | q :: rest when compare_first q p < 0 -> from i rest (q :: before)
      | _ -> from (i + 1) come (if List.memq p gone then before else p :: before)
  in
  { s with processes = Scc_data.Long_array.of_list (from 0 (List.sort compare_first come) []) }

let leaf_opt p leaf =
  let rec from i =
    if i >= Array.length p.leaves then None
    else if p.leaves.(i).leaf = leaf then Some p.leaves.(i)
    else from (i + 1)
  in
  from 0

let has_leaf p leaf = Array.exists (fun (l : leaf) -> l.leaf = leaf) p.leaves

let with_leaves (s : t) leaves =
  let wanted = Array.make (1 + List.fold_left Int.max (-1) leaves) false in
  List.iter (fun leaf -> wanted.(leaf) <- true) leaves;
  let is_wanted (l : leaf) = l.leaf < Array.length wanted && wanted.(l.leaf) in
  restricted s (fun i -> Array.exists is_wanted s.processes.(i).leaves)

let leaf_of p leaf =
  match leaf_opt p leaf with
  | Some l -> l
  | None -> Scc_base.Bug.fail __POS__ "a leaf that the process has not"

let home state leaf = Array.find_opt (fun p -> has_leaf p leaf) state.processes

let gone (m : Model.t) state =
  if not (Model.absorbs m) then []
  else List.filter (fun leaf -> Option.is_none (home state leaf)) (List.init (Array.length m.leaves) Fun.id)

let mass (m : Model.t) p =
  let add sum l =
    let leaf = m.leaves.(l.leaf) in
    match sum with
    | Some s when not leaf.fixed -> Some (Rat.add s leaf.mass)
    | _ -> None
  in
  Array.fold_left add (Some Rat.zero) p.leaves

let size (m : Model.t) p =
  Array.fold_left (fun n l -> n + Array.length m.leaves.(l.leaf).parts) 0 p.leaves

let part_position (m : Model.t) l part =
  Vec.add l.position (Quaternion.apply l.turned m.leaves.(l.leaf).parts.(part).offset)

let placed (m : Model.t) l part =
  { Placed.solid = m.leaves.(l.leaf).parts.(part).solid; turned = l.turned; at = part_position m l part }

let centroid (m : Model.t) l =
  Vec.add l.position (Quaternion.apply l.turned (Model.leaf_centroid m.leaves.(l.leaf)))

(* A point that is inside of the leaf, and so of no other one. *)
let inside (m : Model.t) l =
  let part = m.leaves.(l.leaf).parts.(0) in
  Vec.add l.position (Quaternion.apply l.turned (Vec.add part.offset part.solid.Scc_geometry.Solid.centroid))

let compare_places m a b =
  match Vec.compare a.position b.position with
  | 0 -> (
      match Quaternion.compare a.turned b.turned with 0 -> Vec.compare (inside m a) (inside m b) | c -> c)
  | c -> c

let centre_of_mass m p =
  match mass m p with
  | Some total when Array.length p.leaves > 1 ->
    let add sum l = Vec.axpy m.leaves.(l.leaf).mass (centroid m l) sum in
    Vec.scale (Rat.div Rat.one total) (Array.fold_left add Vec.zero p.leaves)
  | Some _ | None -> centroid m p.leaves.(0)

let components leaves bonds =
  let n = Array.length leaves in
  let index = Hashtbl.create n in
  Array.iteri (fun i (l : leaf) -> Hashtbl.replace index l.leaf i) leaves;
  let near = Array.make n [] in
  let ends b = (Hashtbl.find index b.one.at, Hashtbl.find index b.two.at) in
  Array.iter
    (fun b ->
       let i, j = ends b in
       near.(i) <- j :: near.(i);
       near.(j) <- i :: near.(j))
    bonds;
  let group = Array.make n (-1) in
  let rec flood g = function
    | [] -> ()
    | i :: rest when group.(i) >= 0 -> flood g rest
    | i :: rest ->
      group.(i) <- g;
      flood g (List.rev_append near.(i) rest)
  in
  let groups = ref 0 in
  Array.iteri
    (fun i g ->
       if g < 0 && group.(i) < 0 then begin
         flood !groups [ i ];
         incr groups
       end)
    (Array.copy group);
  let members g = List.filteri (fun i _ -> group.(i) = g) (Array.to_list leaves) in
  let inner g = List.filter (fun b -> group.(fst (ends b)) = g) (Array.to_list bonds) in
  List.init !groups (fun g -> (members g, inner g))

let compare_leaf a b =
  Int.compare a.leaf b.leaf <?> fun () ->
    Vec.compare a.position b.position <?> fun () ->
      Behaviour.compare_aged a.behaviour b.behaviour <?> fun () ->
        Quaternion.compare a.turned b.turned <?> fun () -> Rat.compare a.waited b.waited

let phase_rank = function Moving -> 0 | Due -> 1 | Steered -> 2
let compare_phase a b = Int.compare (phase_rank a) (phase_rank b)

let compare_draw a b =
  match (a, b) with
  | Waits, Waits -> 0
  | Waits, Drawn _ -> -1
  | Drawn _, Waits -> 1
  | Drawn g, Drawn h -> Given.compare g h

let compare_lots (a : lots) (b : lots) =
  Rat.compare a.since b.since <?> fun () -> List.compare compare_pending a.pending b.pending

let compare_process p q =
  if p == q then 0
  else
    Arrays.compare compare_leaf p.leaves q.leaves <?> fun () ->
      Arrays.compare compare_bond p.bonds q.bonds <?> fun () ->
        Vec.compare p.velocity q.velocity <?> fun () ->
          Option.compare Rat.compare p.clock q.clock <?> fun () ->
            Vec.compare p.spin q.spin <?> fun () ->
              Rat.compare p.since q.since <?> fun () ->
                Option.compare Rat.compare p.lasts q.lasts <?> fun () ->
                  Vec.compare p.kept q.kept <?> fun () ->
                    Option.compare compare_phase p.phase q.phase <?> fun () ->
                      Option.compare compare_draw p.draw q.draw <?> fun () ->
                        Option.compare compare_lots p.lots q.lots

let compare_step a b = Rat.compare a.remaining b.remaining <?> fun () -> compare_phase a.phase b.phase

let compare a b =
  Arrays.compare compare_process a.processes b.processes <?> fun () ->
    Option.compare compare_step a.step b.step <?> fun () -> Option.compare Rat.compare a.time b.time

let equal a b = compare a b = 0
let mix h k = (h * 1_000_003) lxor k
let hash_option hash = function None -> 3 | Some x -> hash x

let hash_leaf h l =
  let turned = if Quaternion.is_identity l.turned then 0 else Quaternion.hash l.turned in
  mix (mix (mix h l.leaf) (Vec.hash l.position)) (Behaviour.hash_aged l.behaviour) lxor turned

let hash_finish f = mix f.at (Site.hash f.site)
let hash_bond (b : bond) = mix (hash_finish b.one) (hash_finish b.two)

let hash_lots ({ since; pending } : lots) =
  List.fold_left (fun h (b, lot) -> mix (mix h (hash_bond b)) (lot_rank lot)) (Rat.hash since) pending

let hash_process_from h p =
  let h = Array.fold_left hash_leaf h p.leaves in
  let h = Array.fold_left (fun h b -> mix h (hash_bond b)) h p.bonds in
  let spin = if Vec.is_zero p.spin then 0 else mix (Vec.hash p.spin) (Rat.hash p.since) in
  let draw = match p.draw with None -> 0 | Some Waits -> 1 | Some (Drawn g) -> mix 2 (Given.hash g) in
  let lots = match p.lots with None -> 0 | Some lots -> hash_lots lots in
  mix (mix h (Vec.hash p.velocity)) (hash_option Rat.hash p.clock) lxor spin lxor draw lxor lots

let hash_process p = hash_process_from 7 p land max_int
let equal_process p q = compare_process p q = 0
let hash_step s = mix (Rat.hash s.remaining) (phase_rank s.phase)

let hash s =
  let h = Array.fold_left hash_process_from 7 s.processes in
  let h = mix (mix h (hash_option hash_step s.step)) (hash_option Rat.hash s.time) in
  h land max_int
