open Scc_base
open Scc_data
open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_syntax
open Scc_calculus

type t = { name : string; one : int * Site.t; two : int * Site.t }

(* The leaf that a feature begins with, and the feature on its shape. *)
let read_end (c : Context.t) env (bodies : Bodies.t) (f : Ast.feature) =
  let*? f = Feature_name.read c.report env f in
  match f.prefix with
  | [] ->
    Report.error c.report Code.unknown_feature f.span "say of which process this feature is, as in `p.right`";
    None
  | (name, at) :: rest -> (
      match Registry.find bodies.registry name with
      | Some (Leaf i) | Some (Process [ i ]) ->
        let*? leaf = bodies.leaves.(i) in
        let*? meaning = Feature_name.on_shape c.report ~own:None leaf.shape { f with prefix = rest } in
        Some (i, meaning)
      | Some (Process [] | Family []) ->
        Report.error c.report Code.wrong_kind at
          "`%s` is a family that has no members here; a bond joins two bodies" name;
        None
      | Some (Process _ | Family _) ->
        Report.error c.report Code.wrong_kind at
          "`%s` stands for several bodies; a bond joins two of them" name;
        None
      | None ->
        Registry.unknown bodies.registry c.report at name;
        None)

let leaf (bodies : Bodies.t) i =
  match bodies.leaves.(i) with
  | Some l -> l
  | None -> Bug.fail __POS__ "a bond of a body with faults"

let site_text (l : Bodies.leaf) (site : Site.t) =
  let part = l.parts.(site.part) in
  part.name ^ "." ^ Polyhedron.feature_name part.solid.polyhedron site.feature

(* The parts of two sites, where they are to each other, and the pair of the two features if they touch. *)
let meeting (c : Context.t) ((p : Bodies.leaf), (f : Site.t)) ((q : Bodies.leaf), (g : Site.t)) =
  let a = p.parts.(f.part) and b = q.parts.(g.part) in
  let obstacle = Obstacle_cache.find c.obstacles a.solid b.solid in
  let offset = Vec.sub (Vec.add q.position b.offset) (Vec.add p.position a.offset) in
  let is_pair (pair : Contact.pair) = Feature.equal pair.first f.feature && Feature.equal pair.second g.feature in
  let pair () = List.find_opt is_pair (c.touching obstacle offset) in
  (a, b, obstacle, offset, pair)

let check_contact (c : Context.t) at ((p, f) as one) ((q, g) as two) =
  let a, b, obstacle, offset, pair = meeting c one two in
  match Obstacle.relation obstacle offset with
  | Interpenetrating -> ()
  | Apart -> Report.error c.report Code.not_touching at "`%s` and `%s` do not touch" a.name b.name
  | Touching ->
    if Option.is_none (pair ()) then
      let highest = Contact.highest obstacle offset in
      Report.error c.report Code.not_touching at "%s and %s do not touch" (site_text p f) (site_text q g)
        ~hint:
          (Printf.sprintf "the bodies touch at %s and %s"
             (site_text p { f with feature = highest.first })
             (site_text q { g with feature = highest.second }))

(* How two features of parts touch, if they do: 0 at a point, 1 along a segment, 2 in an area. *)
let touch c one two =
  let _, _, obstacle, offset, pair = meeting c one two in
  match Obstacle.relation obstacle offset with
  | Interpenetrating | Apart -> None
  | Touching -> Option.map (fun (pair : Contact.pair) -> pair.dimension) (pair ())

(* A name may stand for several pieces of a face: the bond is between two of them that touch, in an area if any do,
   and of those that touch alike the first ones. *)
let ends (c : Context.t) at (p, (m : Feature_name.meaning)) (q, (n : Feature_name.meaning)) =
  match (m.inside, n.inside) with
  | [ f ], [ g ] ->
    check_contact c at (p, f) (q, g);
    Some (f, g)
  | fs, gs -> (
      let better best f g =
        match (best, touch c (p, f) (q, g)) with
        | Some (most, _), Some d when d <= most -> best
        | _, Some d -> Some (d, (f, g))
        | _, None -> best
      in
      match List.fold_left (fun best f -> List.fold_left (fun best g -> better best f g) best gs) None fs with
      | Some (_, found) -> Some found
      | None ->
        Report.error c.report Code.not_touching at
          "no pieces of these features of `%s` and `%s` touch" p.name
          q.name;
        None)

(* What is bound has one spin, and the velocities of centroids differ by what it gives (Definition 4.5). *)
let check_motion (c : Context.t) at (p : Bodies.leaf) (q : Bodies.leaf) =
  let note (l : Bodies.leaf) = (l.span, Printf.sprintf "`%s` is here" l.name) in
  let differ (what, several) of_p of_q explanation =
    let notes = [ note p; note q ] in
    if p.fixed || q.fixed then
      let wall, other, value = if p.fixed then (p, q, of_q) else (q, p, of_p) in
      Report.error c.report Code.velocity_mismatch at "`%s` has the %s %s, and is bound to `%s`, which is fixed"
        other.name what (Vec.to_string value) wall.name ~notes
    else
      Report.error c.report Code.velocity_mismatch at "`%s` and `%s` have the %s %s and %s, and %s" p.name
        q.name several (Vec.to_string of_p) (Vec.to_string of_q) explanation ~notes
  in
  let turn () = Vec.cross p.spin (Vec.sub (Bodies.centroid q) (Bodies.centroid p)) in
  if not (Vec.equal p.spin q.spin) then differ ("spin", "spins") p.spin q.spin "what is bound turns as one"
  else
    let expected = if Vec.is_zero p.spin then p.velocity else Vec.add p.velocity (turn ()) in
    if not (Vec.equal expected q.velocity) then
      differ ("velocity", "velocities") p.velocity q.velocity
        (if Vec.is_zero p.spin then "what is bound moves as one"
         else
           Printf.sprintf "what is bound moves as one: with this spin the velocity of `%s` is %s" q.name
             (Vec.to_string expected))

(* A bond between processes that are both left out of the network is left out with them. *)
let check_included (c : Context.t) (composition : Composition.t) bodies (at, i) (at', j) =
  let refuse at out inside =
    Report.error c.report Code.wrong_kind at
      "`%s` is not in the network, and this bond joins it to `%s`, which is"
      (leaf bodies out).name (leaf bodies inside).name;
    false
  in
  match (composition.included.(i), composition.included.(j)) with
  | true, false -> refuse at' j i
  | false, true -> refuse at i j
  | true, true | false, false -> true

let check_member (c : Context.t) bodies (process : Bodies.process) (at, i) =
  List.exists (Int.equal i) process.members
  ||
  begin
    Report.error c.report Code.wrong_kind at "`%s` is not a part of the process `%s`" (leaf bodies i).name
      process.name
      ~hint:"a bond with another process is declared apart: `bond <a, {…}>`";
    false
  end

(* What bonds have joined: into whom, and which two. *)
type joined = { wholes : Union_find.t; bound : (int * int, unit) Hashtbl.t; cyclic : bool }

(* Bonds make a tree, or, if the model says so, a graph without double edges (reading I-37). *)
let joins (c : Context.t) joined at ((p : Bodies.leaf), i) ((q : Bodies.leaf), j) =
  let ends = (Int.min i j, Int.max i j) in
  let bound = Hashtbl.mem joined.bound ends in
  let apart = Union_find.union joined.wholes i j in
  Hashtbl.replace joined.bound ends ();
  if bound && joined.cyclic then
    Report.error c.report Code.cyclic_bonds at "`%s` and `%s` have a bond already, and two bodies have one at most"
      p.name q.name
  else if not (apart || joined.cyclic) then
    Report.error c.report Code.cyclic_bonds at
      "this bond closes a cycle: `%s` and `%s` are joined already, and the bonds of a process are a tree" p.name
      q.name
      ?hint:(if bound then None else Some "`bonds cyclic` lets the bonds of a process close rings");
  apart || (joined.cyclic && not bound)

(* [admits]: whether the bond may join these two. *)
let read_bond (c : Context.t) (bodies : Bodies.t) joined ~admits (env, (b : Ast.bond)) =
  let one = read_end c env bodies b.first and two = read_end c env bodies b.second in
  let*? i, m = one in
  let*? j, n = two in
  let p = leaf bodies i and q = leaf bodies j in
  if not (admits (b.first.at, i) (b.second.at, j)) then None
  else if Int.equal i j then begin
    Report.error c.report Code.cyclic_bonds b.bond_span "`%s` cannot be bound to itself" p.name;
    None
  end
  else if p.absorbs || q.absorbs then begin
    let who = if p.absorbs then p else q in
    Report.error c.report Code.bad_absorber b.bond_span "`%s` absorbs what hits it, and is bound to nobody"
      who.name ~notes:[ (who.span, Printf.sprintf "`%s` is here" who.name) ];
    None
  end
  else if not (joins c joined b.bond_span (p, i) (q, j)) then None
  else begin
    let found = ends c b.bond_span (p, m) (q, n) in
    check_motion c b.bond_span p q;
    Option.map (fun (f, g) -> { name = b.bond.it; one = (i, f); two = (j, g) }) found
  end

let included (composition : Composition.t) joint = composition.included.(fst joint.one)

let read (c : Context.t) (program : Program.t) (bodies : Bodies.t) composition =
  let joined =
    {
      wholes = Union_find.create (Array.length bodies.leaves);
      bound = Hashtbl.create 16;
      cyclic = (match Settings.bonds program.settings with Cyclic -> true | Acyclic -> false);
    }
  in
  let of_process (process : Bodies.process) =
    let is_member = check_member c bodies process in
    let admits one two = is_member one && is_member two in
    List.filter_map (read_bond c bodies joined ~admits) process.bonds
  in
  let inner = List.concat_map of_process (Array.to_list bodies.processes) in
  let admits = check_included c composition bodies in
  let outer = List.filter_map (read_bond c bodies joined ~admits) program.bonds in
  List.filter (included composition) (List.append inner outer)
