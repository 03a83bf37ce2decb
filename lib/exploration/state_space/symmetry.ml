open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_property

(* The leaves of each class, increasing; and room for where the leaves of a state are. *)
type t = { members : int array array; places : Vec.t array; present : bool array }

let none = { members = [||]; places = [||]; present = [||] }
let is_none s = Array.length s.members = 0
let classes s = Array.to_list (Array.map Array.to_list s.members)

(** {2 Which leaves} *)

let equal_part (a : Model.part) (b : Model.part) =
  a.solid.Solid.id = b.solid.Solid.id && Model.same_offset a b && Rat.equal a.mass b.mass

let alike (a : Model.leaf) (b : Model.leaf) =
  (not a.fixed) && (not b.fixed)
  && String.equal a.template b.template
  && Scc_data.Arrays.equal equal_part a.parts b.parts
  && Rat.equal a.mass b.mass && Law.equal a.law b.law

(* To change places with is an equivalence, so that one member speaks for its class. Of several searches each has
   to be the same by itself: two that change places with each other may be met by one state, under two names, and
   in the model by none for the one of them. *)
let find (m : Model.t) ~(initial : State.t) ~searched ~evaluated =
  let searched = List.concat_map (fun f -> Plan.searches (Plan.of_formula f)) searched in
  let named = Array.make (Array.length m.leaves) false and apart = Array.make (Array.length m.leaves) false in
  let set a i = a.(i) <- true in
  List.iter (set apart) (List.concat_map Formula.leaves evaluated);
  List.iter (set apart) (List.concat_map Formula.leaves_of_events (searched @ evaluated));
  List.iter (set named) (List.concat_map Formula.leaves searched);
  let exchangeable = lazy (List.map Exchangeable.make searched) in
  let invariant i j = List.for_all (fun f -> Exchangeable.are f i j) (Lazy.force exchangeable) in
  let fits i = function
    | [] -> false
    | j :: _ -> alike m.leaves.(i) m.leaves.(j) && ((not (named.(i) || named.(j))) || invariant i j)
  in
  let join i = Scc_data.Lists.put (fun group -> if fits i group then Some (i :: group) else None) [ i ] in
  let place groups i = if apart.(i) || m.leaves.(i).fixed then groups else join i groups in
  let is_there = Array.make (Array.length m.leaves) false in
  Array.iter (fun (p : State.process) -> Array.iter (fun l -> is_there.(l.State.leaf) <- true) p.leaves)
    initial.processes;
  let leaves = List.filter (fun i -> is_there.(i)) (List.init (Array.length m.leaves) Fun.id) in
  let groups = List.fold_left place [] leaves in
  let classes = List.filter (fun g -> List.compare_length_with g 2 >= 0) groups in
  let members = Array.of_list (List.map (fun g -> Array.of_list (List.rev g)) classes) in
  let count = Array.length m.leaves in
  { members; places = Array.make count Vec.zero; present = Array.make count false }

(** {2 Canonical form} *)

(* The first of the members, in order of their places, and none of the others. *)
let is_in_order s members =
  let n = Array.length members in
  let there i = i < n && s.present.(members.(i)) in
  let rec gone i = i >= n || ((not (there i)) && gone (i + 1)) in
  let rec from i =
    if not (there i) then gone i
    else (i = 0 || Vec.compare s.places.(members.(i - 1)) s.places.(members.(i)) < 0) && from (i + 1)
  in
  from 0

let place s (p : State.process) =
  for i = 0 to Array.length p.leaves - 1 do
    let l = p.leaves.(i) in
    s.places.(l.leaf) <- l.position;
    s.present.(l.leaf) <- true
  done

(* Where some of a class are gone (rule Absorb), those that are left take the first names. *)
let canonical s each =
  if is_none s then None
  else begin
    Array.fill s.present 0 (Array.length s.present) false;
    each (place s);
    if Array.for_all (is_in_order s) s.members then None
    else begin
      let image = Array.init (Array.length s.present) Fun.id in
      let sort members =
        let left = Array.of_list (List.filter (fun l -> s.present.(l)) (Array.to_list members)) in
        Array.sort (fun a b -> Vec.compare s.places.(a) s.places.(b)) left;
        Array.iteri (fun i leaf -> image.(leaf) <- members.(i)) left
      in
      Array.iter sort s.members;
      Some (fun leaf -> image.(leaf))
    end
  end
