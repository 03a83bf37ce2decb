open Scc_base
open Scc_data
open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_syntax

(* A part with what was written about its motion. *)
type draft = { part : Shape.part; motion : Attributes.t }

(* What is checked here is checked for these values of parameters that have ranges; for all others it is once the
    whole network is known. *)
let placement (c : Context.t) (a : Attributes.t) =
  { Affine.linear = a.at.linear; translation = Form.at c.point a.at.translation }

let read_part (c : Context.t) env (p : Ast.part) =
  let basic = Templates.basic c env ~label:p.part.it p.part_solid in
  let a = Attributes.read c.report env p.part_attributes in
  Option.iter
    (fun at ->
       Report.error c.report Code.bad_absorber at "a part absorbs nothing by itself"
         ~hint:"write `absorb` after the name of the compound, where a body of it is declared `fixed`")
    a.absorb;
  if Option.is_none a.mass then
    Report.error c.report Code.bad_value p.part.at "the part `%s` has no mass" p.part.it
      ~hint:"every part of a compound needs `mass m` with m > 0";
  let*? basic = basic in
  let*? mass, _ = a.mass in
  let placement = placement c a in
  if not a.complete then None
  else
    let solid = c.solid basic placement.linear in
    let place = a.at.translation in
    let part = { Shape.name = p.part.it; basic; placement; place; solid; mass; span = p.part.at } in
    Some { part; motion = a }

let check_names (c : Context.t) (parts : Ast.part list) =
  let seen = Hashtbl.create 8 in
  let fresh (p : Ast.part) =
    match Hashtbl.find_opt seen p.part.it with
    | None ->
      Hashtbl.add seen p.part.it p.part.at;
      true
    | Some first ->
      Report.error c.report Code.duplicate_name p.part.at "the part `%s` is declared twice" p.part.it
        ~notes:[ (first, "the first is here") ];
      false
  in
  List.for_all Fun.id (List.map fresh parts)

let centroid d = Vec.add d.part.placement.translation d.part.solid.centroid

let mismatch (c : Context.t) (name : Ast.name) given first d (one, several) of_one of_other explanation =
  let place d = match given d.motion with Some (_, at) -> at | None -> d.part.span in
  Report.error c.report Code.velocity_mismatch (place d)
    "the parts `%s` and `%s` of `%s` have the %s %s and %s, and %s"
    first.part.name d.part.name name.it several (Vec.to_string of_one) (Vec.to_string of_other) explanation
    ~notes:[ (place first, Printf.sprintf "the %s of `%s` is here" one first.part.name) ]

(* The parts of one rigid body have one spin, and the velocities of their centroids differ by what it gives
   (Definition 4.5). *)
let check_motion (c : Context.t) (name : Ast.name) drafts =
  let first = drafts.(0) in
  let v = Attributes.velocity first.motion and spin = Attributes.spin first.motion in
  let spins_apart d = not (Vec.equal spin (Attributes.spin d.motion)) in
  let expected d = Vec.add v (Vec.cross spin (Vec.sub (centroid d) (centroid first))) in
  let moves_apart d = not (Vec.equal (expected d) (Attributes.velocity d.motion)) in
  let drafts = Array.to_list drafts in
  match (List.find_opt spins_apart drafts, List.find_opt moves_apart drafts) with
  | None, None -> true
  | Some d, _ ->
    mismatch c name (fun (a : Attributes.t) -> a.spin) first d ("spin", "spins") spin (Attributes.spin d.motion)
      "glued parts turn as one";
    false
  | None, Some d ->
    mismatch c name (fun (a : Attributes.t) -> a.velocity) first d ("velocity", "velocities") v
      (Attributes.velocity d.motion)
      (if Vec.is_zero spin then "glued parts move as one"
       else
         Printf.sprintf "glued parts move as one: with this spin the velocity of `%s` is %s" d.part.name
           (Vec.to_string (expected d)));
    false

(* Of the centre of mass. *)
let common_velocity drafts =
  let add (momentum, mass) d =
    let m = d.part.Shape.mass in
    (Vec.axpy m (Attributes.velocity d.motion) momentum, Rat.add mass m)
  in
  let momentum, mass = Array.fold_left add (Vec.zero, Rat.zero) drafts in
  Vec.scale (Rat.div Rat.one mass) momentum

let placed i (p : Shape.part) = { Overlap.body = i; solid = p.solid; position = p.placement.translation }

let check_overlaps (c : Context.t) (name : Ast.name) (parts : Shape.part array) =
  let bodies = Array.mapi placed parts in
  let report (i, j) =
    let where =
      match Overlap.common_point bodies.(i) bodies.(j) with
      | Some x -> Printf.sprintf ": the point %s is inside both" (Vec.to_string x)
      | None -> ""
    in
    Report.error c.report Code.interpenetration parts.(j).span
      "the parts `%s` and `%s` of `%s` interpenetrate%s"
      parts.(i).name parts.(j).name name.it where
      ~notes:[ (parts.(i).span, Printf.sprintf "`%s` is here" parts.(i).name) ]
  in
  let found = Overlap.pairs ~limit:10 c.obstacles bodies in
  List.iter report found;
  List.length found = 0

let feature_text (p : Shape.part) feature =
  p.name ^ "." ^ Polyhedron.feature_name p.basic.polyhedron feature

let not_highest (c : Context.t) at (p : Shape.part) (q : Shape.part) (pair : Contact.pair) =
  let best = feature_text p pair.first ^ " ~ " ^ feature_text q pair.second in
  Report.error c.report Code.not_highest at
    "this is not the pair of the highest dimension at which `%s` and `%s` touch: that is %s" p.name q.name
    best
    ~hint:(Printf.sprintf "write `glue %s`" best)

(* A glue is the highest touching pair of its two parts (reading I-4). *)
let check_contact (c : Context.t) at (p, f) (q, g) =
  let obstacle = Obstacle_cache.find c.obstacles p.Shape.solid q.Shape.solid in
  let offset = Vec.sub q.placement.translation p.placement.translation in
  match Obstacle.relation obstacle offset with
  | Interpenetrating -> ()
  | Apart ->
    Report.error c.report Code.not_touching at "the parts `%s` and `%s` do not touch" p.name q.name
  | Touching ->
    let highest = Contact.highest obstacle offset in
    let is_pair (pair : Contact.pair) = Feature.equal pair.first f && Feature.equal pair.second g in
    if is_pair highest then ()
    else if List.exists is_pair (c.touching obstacle offset) then not_highest c at p q highest
    else
      Report.error c.report Code.not_touching at "%s and %s do not touch" (feature_text p f)
        (feature_text q g)
        ~hint:
          (Printf.sprintf "the parts touch at %s and %s" (feature_text p highest.first)
             (feature_text q highest.second))

let read_site (c : Context.t) env compound (f : Ast.feature) =
  let*? f = Feature_name.read c.report env f in
  Option.bind (Feature_name.on_shape c.report ~own:None (Compound compound) f) Feature_name.one

let read_glue (c : Context.t) env (compound : Shape.compound) joined (g : Ast.glue) =
  match (read_site c env compound g.glue_first, read_site c env compound g.glue_second) with
  | Some a, Some b ->
    let p = compound.parts.(a.part) and q = compound.parts.(b.part) in
    if Int.equal a.part b.part then
      Report.error c.report Code.not_connected g.glue_span "the part `%s` cannot be glued to itself" p.name
    else if not (Union_find.union joined a.part b.part) then
      Report.error c.report Code.not_connected g.glue_span
        "the parts `%s` and `%s` are joined already: the glues of a compound are a tree" p.name q.name
    else check_contact c g.glue_span (p, a.feature) (q, b.feature);
    Some { Shape.one = a; two = b }
  | _ -> None

(* Whether the parts are at a known place from each other. *)
let is_open (compound : Shape.compound) (g : Shape.glue) =
  let (x, y, z), (x', y', z') = (compound.parts.(g.one.part).place, compound.parts.(g.two.part).place) in
  Option.is_none (Form.fixed (Form.sub x x', Form.sub y y', Form.sub z z'))

let check_connected (c : Context.t) (name : Ast.name) (parts : Shape.part array) joined =
  let apart i = Union_find.find joined i <> Union_find.find joined 0 in
  let rec first i = if i = Array.length parts then None else if apart i then Some i else first (i + 1) in
  match first 0 with
  | None -> ()
  | Some i ->
    Report.error c.report Code.not_connected parts.(i).span "no glue joins the part `%s` to `%s` in `%s`"
      parts.(i).name parts.(0).name name.it

let build (c : Context.t) env (name : Ast.name) drafts glues =
  let parts = Array.map (fun d -> d.part) drafts in
  let velocity = common_velocity drafts and spin = Attributes.spin drafts.(0).motion in
  let compound = { Shape.cid = c.fresh (); clabel = name.it; parts; open_glues = []; velocity; spin;
                   drawn = None } in
  let joined = Union_find.create (Array.length parts) in
  let rigid = check_motion c name drafts in
  let disjoint = check_overlaps c name parts in
  let read = List.map (read_glue c env compound joined) glues in
  if List.for_all Option.is_some read then check_connected c name parts joined;
  let open_glues = List.filter (is_open compound) (List.filter_map Fun.id read) in
  if rigid && disjoint then Some (Shape.Compound { compound with open_glues }) else None

(* That the glue names parts, where these are not known otherwise. *)
let check_parts (c : Context.t) env (name : Ast.name) (parts : Ast.part list) (g : Ast.glue) =
  let names () = List.map (fun (p : Ast.part) -> p.part.it) parts in
  let check (f : Ast.feature) =
    match Feature_name.read c.report env f with
    | Some { prefix = (first, at) :: _; _ } when not (List.mem first (names ())) ->
      Report.error c.report Code.unknown_feature at "`%s` has no part `%s`" name.it first ~near:(first, names)
    | Some _ | None -> ()
  in
  check g.glue_first;
  check g.glue_second

let make (c : Context.t) (at : Span.t) parts glues env label =
  let name = { Ast.it = label; at } in
  let distinct = check_names c parts in
  let drafts = List.map (read_part c env) parts in
  if distinct && List.for_all Option.is_some drafts then
    match List.filter_map Fun.id drafts with
    | [] ->
      Report.error c.report Code.not_connected name.at "the compound `%s` has no parts" name.it;
      None
    | drafts -> build c env name (Array.of_list drafts) glues
  else begin
    List.iter (check_parts c env name parts) glues;
    None
  end

let declare (c : Context.t) env (h : Ast.head) parts glues definitions =
  Templates.declare c env h definitions (make c h.declared.at parts glues)
