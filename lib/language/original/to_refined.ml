open Scc_base
open Scc_syntax
module Names = Map.Make (String)

(* What is known of a shape that is declared without parameters. *)
type shape = {
  name : Ast.name;
  solid : Ast.solid;  (* as in the language *)
  regions : (Ast.name * Region.t) list;  (* that are no features, in order *)
  mutable inline : Region.t list;  (* in behaviours that are of the shape *)
  mutable cells : (Extent.solid * Cells.t) option;  (* where some region is no union of features as it is
                                                       written *)
  mutable refused : bool;  (* its regions have a fault that has been told *)
}

type t = {
  plain : Plain.t;
  setting : Setting.t;
  declared : shape Names.t;
  balls : (int, unit) Hashtbl.t;  (* that are used, by their corners *)
  faults : Diag.t list ref;
}

(* {1 Faults}

   Each is kept, and something harmless stands in its place. *)

let attempt t ~default f =
  match Fault.catch f with
  | Ok x -> x
  | Error d ->
    t.faults := d :: !(t.faults);
    default

(* {1 Regions as they are written} *)

let is_simple x = Option.is_some (Region.members x)

(* The names of regions of the shape give way to what they stand for. *)
let expanded shape (x : Region.t) members =
  let left = ref Extent.most_parts in
  let rec one (m : Ast.member) =
    decr left;
    if !left < 0 then
      Fault.refuse Code.too_deep x.at "a region is made of more than %d others, or of itself" Extent.most_parts;
    match m.feature.it with
    | Named { it = [ { name; indices = [] } ]; _ } when not m.only -> (
        match List.find_opt (fun ((n : Ast.name), _) -> String.equal n.it name.it) shape.regions with
        | Some (_, y) -> List.concat_map one (Option.value (Region.members y) ~default:[])
        | None -> [ m ])
    | _ -> [ m ]
  in
  List.concat_map one members

let rec mentions names (x : Region.t) =
  match x.kind with
  | Named { it = [ { name; indices = [] } ]; _ } -> names name.it
  | Union (y, z) | Common (y, z) | Less (y, z) -> mentions names y || mentions names z
  | Interior y -> mentions names y
  | Named _ | Hull _ | Polygon _ | Segment _ | Point _ | Half _ | Cap _ | Whole | Empty -> false

let has_region shape name = List.exists (fun ((n : Ast.name), _) -> String.equal n.it name) shape.regions

(* {1 Which shape a region is on} *)

let of_solid t (s : Ast.solid) =
  let rec find (s : Ast.solid) =
    match s.it with
    | Template { qualifier = None; target; indices = []; arguments = [] } -> Names.find_opt target.it t.declared
    | Scaled (s, _) -> find s
    | _ -> None
  in
  find s

let by_names t (x : Region.t) =
  let those = List.filter (fun (_, s) -> mentions (has_region s) x) (Names.bindings t.declared) in
  match those with
  | [] -> None
  | [ (_, s) ] -> Some s
  | (_, s) :: (_, s') :: _ ->
    Fault.refuse Code.region_of_what x.at "a region of this name is on `%s` and on `%s`" s.name.it s'.name.it
      ~hint:"say of which shape the behaviour is, as in `behaviour B on S = …`"

let shape_of t on x = match on with Some s -> Some s | None -> by_names t x

(* {1 Members} *)

let no_shape (x : Region.t) =
  Fault.refuse Code.region_of_what x.at "it is not known on which shape this region is"
    ~hint:"declare it, as in `region pocket on Cube = …`, or say of which shape the behaviour is: `behaviour \
           B on Cube = …`"

let members t on (x : Region.t) =
  match shape_of t on x with
  | Some ({ cells = Some (solid, cells); _ } as s) ->
    let found = Cells.members cells x.at (Extent.resolve solid x) in
    (match (found, x.kind) with
     | [], Empty -> []
     | [], _ -> Fault.refuse Code.bad_region x.at "no point of the surface of `%s` is in this region" s.name.it
     | found, _ -> found)
  | Some { refused = true; _ } -> []
  | Some s -> (
      match Region.members x with
      | Some ms -> expanded s x ms
      | None -> no_shape x)
  | None -> ( match Region.members x with Some ms -> ms | None -> no_shape x)

let channel t on (c : Ast.channel) =
  match c.features with
  | [ { feature; only = false } ] -> (
      match Tree.region feature with
      | None -> c
      | Some e ->
        attempt t ~default:c (fun () -> { c with features = members t on (Fault.ok (Region.read e)) }))
  | _ -> c

let feature t (f : Ast.feature) =
  match Tree.region f with
  | None -> f
  | Some e ->
    attempt t ~default:f (fun () ->
        match Region.members (Fault.ok (Region.read e)) with
        | Some [ { feature; only = false } ] -> feature
        | Some _ | None ->
          Fault.refuse Code.not_common e.at "a bond or glue is on the surface of one feature of each body"
            ~hint:"the feature of each which has all that they have in common inside of it, as in `p.right * \
                   q.left`")

(* {1 Solids} *)

let rec solid t (s : Ast.solid) : Ast.solid =
  let made () : Ast.solid =
    match s.it with
    | Scaled (inner, v) -> { s with it = Scaled (solid t inner, v) }
    | Template ({ qualifier = None; indices = []; _ } as r) when not (Names.mem r.target.it t.declared) -> (
        match Setting.curved t.setting r with
        | Some c ->
          (match c with Sphere (b, _) -> Hashtbl.replace t.balls b.corners () | Cylinder _ | Cone _ -> ());
          { s with it = Setting.solid s.at c }
        | None when String.equal r.target.it "polyhedron" && r.arguments <> [] ->
          { s with it = Hull (List.mapi (fun i v -> (Tree.at v.Ast.at (Printf.sprintf "v%d" (i + 1)), v))
                                r.arguments) }
        | None -> s)
    | _ -> s
  in
  attempt t ~default:s made

let is_cut (s : shape) = match s.cells with Some (_, c) -> Cells.is_cut c | None -> false

let cut_one t (s : Ast.solid) =
  match s.it with
  | Template { qualifier = None; target; indices = []; arguments = [] } -> (
      match Names.find_opt target.it t.declared with Some s when is_cut s -> Some s | Some _ | None -> None)
  | _ -> None

(* A solid that cannot be a compound. *)
let whole t (s : Ast.solid) =
  attempt t ~default:s (fun () ->
      match of_solid t s with
      | Some shape when is_cut shape ->
        Fault.refuse Code.cut_shape s.at "`%s` is cut by its regions into the parts of a compound" shape.name.it
          ~hint:"such a shape is that of a body, neither scaled nor a part; give another shape the regions"
      | Some _ | None -> solid t s)

let mass (a : Ast.attribute) = match a.it with Mass e -> Some e | _ -> None

let leaf t ~fixed (l : Ast.leaf) =
  let on = of_solid t l.solid in
  let behaviour = Option.map (Walk.behaviour { Walk.same with channel = channel t on }) l.behaviour in
  match cut_one t l.solid with
  | None -> { l with behaviour; solid = whole t l.solid }
  | Some s ->
    let place = l.solid.at in
    let made m attributes =
      let r : Ast.reference = { qualifier = None; target = s.name; indices = []; arguments = [ m ] } in
      { l with behaviour; solid = Tree.at place (Ast.Template r); attributes }
    in
    attempt t ~default:l (fun () ->
        match (List.filter_map mass l.attributes, fixed) with
        | [], true -> made (Tree.number place Scc_exact.Rat.one) l.attributes
        | [ m ], false -> made m (List.filter (fun a -> Option.is_none (mass a)) l.attributes)
        | [], false ->
          Fault.refuse Code.cut_shape place "a body needs a mass, which the pieces of `%s` share" s.name.it
        | _ :: _, _ -> { l with behaviour })

(* {1 Declarations} *)

let on_of t (on : Ast.reference option) =
  match on with
  | Some { qualifier = None; target; indices = []; arguments = [] } -> Names.find_opt target.it t.declared
  | _ -> None

let rec item t (i : Ast.item) : Ast.item list =
  let bonds = { Walk.same with feature = feature t } in
  let chain ~fixed rest = List.map (fun (b, l) -> (Walk.bond bonds b, leaf t ~fixed l)) rest in
  let made it : Ast.item list = [ { i with it } ] in
  match (i.it, Tree.declared i) with
  | _, Some _ -> []
  | Shape ({ declared; formals = []; _ }, _, _), _
    when Option.fold ~none:false ~some:is_cut (Names.find_opt declared.it t.declared) -> (
      match Names.find_opt declared.it t.declared with
      | Some { cells = Some (_, cells); _ } -> Cells.items cells declared
      | Some _ | None -> [ i ])
  | Shape (head, s, ds), _ -> (
      match Names.find_opt head.declared.it t.declared with
      | Some shape -> made (Shape (head, whole t shape.solid, ds))
      | None -> made (Shape (head, solid t s, ds)))
  | Compound (h, parts, glues, ds), _ ->
    let part (p : Ast.part) = { p with part_solid = whole t p.part_solid } in
    let glued = Walk.item bonds { i with it = Compound (h, List.map part parts, glues, ds) } in
    [ glued ]
  | Behaviour (h, on, b, ds), _ ->
    let shape = on_of t on in
    let on = match shape with Some s when is_cut s -> None | Some _ | None -> on in
    made (Behaviour (h, on, Walk.behaviour { Walk.same with channel = channel t shape } b, ds))
  | Process (s, first, rest), _ -> made (Process (s, leaf t ~fixed:false first, chain ~fixed:false rest))
  | Fixed (s, first, rest), _ -> made (Fixed (s, leaf t ~fixed:true first, chain ~fixed:true rest))
  | For (ranges, body), _ -> made (For (ranges, List.concat (List.map (item t) body)))
  | _ -> [ Walk.item bonds i ]

(* {1 What is declared} *)

let setting faults plain items =
  let add (setting, before) i =
    match Tree.declared i with
    | Some (Curved (word, e)) -> (
        match before with
        | Some (first : Ast.name) ->
          let notes = [ (first.at, "it is said here as well") ] in
          faults := Diag.error ~notes Code.repeated_attribute word.at "how curved solids are taken is said \
                                                                       twice" :: !faults;
          (setting, before)
        | None -> (
            match Fault.catch (fun () -> Setting.read plain word e) with
            | Ok s -> (s, Some word)
            | Error d ->
              faults := d :: !faults;
              (Setting.rough, Some word)))
    | Some (Region _) | None -> (setting, before)
  in
  fst (List.fold_left add (Setting.none, None) items)

(* Regions by the shapes that they are on, in order. *)
let regions faults items =
  let all = Hashtbl.create 16 and seen = Hashtbl.create 16 in
  let add i =
    match Tree.declared i with
    | Some (Region (name, shape, e)) -> (
        match (Region.read e, Hashtbl.find_opt seen (name.it, shape.it)) with
        | Error d, _ -> faults := d :: !faults
        | Ok _, Some (first : Ast.name) ->
          let notes = [ (first.at, "it is declared here") ] in
          faults :=
            Diag.error ~notes Code.duplicate_name name.at "`%s` has two regions `%s`" shape.it name.it :: !faults
        | Ok x, None ->
          Hashtbl.replace seen (name.it, shape.it) name;
          let before = Option.value (Hashtbl.find_opt all shape.it) ~default:[] in
          Hashtbl.replace all shape.it ((shape, (name, x)) :: before))
    | Some (Curved _) | None -> ()
  in
  List.iter add items;
  all

let shapes faults plain regions items =
  let on name =
    Option.value (Hashtbl.find_opt regions name) ~default:[] |> List.rev_map snd
  in
  let add shapes (i : Ast.item) =
    match i.it with
    | Shape (head, s, _) -> (
        let name = head.declared in
        let declared = on name.it in
        let made solid regions = { name; solid; regions; inline = []; cells = None; refused = false } in
        match s.it with
        | Template { qualifier = None; target = { it = "polyhedron"; _ }; indices = []; arguments = _ :: _ as
                                                                                                    points }
          -> (
              match Fault.catch (fun () -> Points.read plain ~at:s.at points declared) with
              | Ok { faces = vertices, faces; others } ->
                Names.add name.it (made { s with it = Faces (vertices, faces) } others) shapes
              | Error d ->
                faults := d :: !faults;
                Names.add name.it (made s declared) shapes)
        | _ -> Names.add name.it (made s declared) shapes)
    | _ -> shapes
  in
  let found = List.fold_left add Names.empty items in
  let missing name all =
    if not (Names.mem name found) then
      List.iter
        (fun ((shape : Ast.name), _) ->
           faults := Diag.error Code.unknown_name shape.at "there is no shape `%s` in this text" name :: !faults)
        all
  in
  Hashtbl.iter missing regions;
  found

(* Regions in behaviours that are known to be of a shape. *)
let find_inline t items =
  let note shape (c : Ast.channel) =
    let add (m : Ast.member) =
      match Option.map Region.read (Tree.region m.feature) with
      | Some (Ok x) -> (
          match Fault.catch (fun () -> shape_of t shape x) with
          | Ok (Some s) -> s.inline <- x :: s.inline
          | Ok None | Error _ -> ())
      | Some (Error _) | None -> ()
    in
    List.iter add c.features;
    c
  in
  let walk shape b = ignore (Walk.behaviour { Walk.same with channel = note shape } b) in
  let leaf (l : Ast.leaf) = Option.iter (walk (of_solid t l.solid)) l.behaviour in
  let rec item (i : Ast.item) =
    match i.it with
    | For (_, body) when List.exists (fun i -> Option.is_some (Tree.declared i)) body ->
      t.faults :=
        Diag.error Code.wrong_kind i.at "`region` and `curved` are not declared in a loop" :: !(t.faults)
    | Behaviour (_, on, b, _) -> walk (on_of t on) b
    | Process (_, first, rest) | Fixed (_, first, rest) ->
      leaf first;
      List.iter (fun (_, l) -> leaf l) rest
    | For (_, body) -> List.iter item body
    | _ -> ()
  in
  List.iter item items

let cut t shape =
  let all = List.map snd shape.regions @ List.rev shape.inline in
  if not (List.for_all is_simple all) then begin
    shape.refused <- true;
    attempt t ~default:() (fun () ->
        let known name = Option.map (fun s -> s.solid) (Names.find_opt name t.declared) in
        let g =
          Plain_solid.of_solid { plain = t.plain; setting = t.setting; shape = known } shape.solid
        in
        let declared name =
          Option.map snd (List.find_opt (fun ((n : Ast.name), _) -> String.equal n.it name) shape.regions)
        in
        let solid = Extent.solid ~plain:t.plain ~declared g.round g.polyhedron in
        let resolved = List.map (fun (x : Region.t) -> (x.at, Extent.resolve solid x)) all in
        shape.cells <- Some (solid, Cells.make solid g.polyhedron ~at:shape.name.at resolved);
        shape.refused <- false)
  end

(* {1 Models} *)

(* The balls that are used, each declared before all else. *)
let balls t =
  let name n = Tree.at Span.none n in
  let ball n =
    let { Scc_geometry.Polyhedron.ifs_vertices; ifs_faces } = Scc_mesh.Curved.ball n in
    let vertices = Array.to_list (Array.map (fun (v, x) -> (name v, Tree.vector Span.none x)) ifs_vertices) in
    let corner v = name (fst ifs_vertices.(v)) in
    let faces = Array.to_list (Array.map (fun (f, c) -> (name f, List.map corner (Array.to_list c)))
                                 ifs_faces) in
    let head = { Ast.declared = name (Setting.ball_name n); places = []; formals = [] } in
    Tree.at Span.none (Ast.Shape (head, Tree.at Span.none (Ast.Faces (vertices, faces)), []))
  in
  Hashtbl.fold (fun n () all -> n :: all) t.balls [] |> List.sort Int.compare |> List.map ball

(* What of the translation is not seen from it. *)
let notes t items =
  let of_item (i : Ast.item) =
    match (i.it, Tree.declared i) with
    | _, Some (Curved _) -> List.map (fun text -> (i.at, text)) (Setting.notes t.setting)
    | Shape (h, _, _), _ -> (
        match Names.find_opt h.declared.it t.declared with
        | Some { cells = Some (_, c); name; _ } when Cells.is_cut c ->
          let parts = List.length (Cells.fractions c) in
          [ (i.at, Printf.sprintf "%s is cut along the regions of it, into %d parts" name.it parts) ]
        | Some _ | None -> [])
    | _ -> []
  in
  List.concat (List.map of_item items)

let model items =
  let faults = ref [] in
  let plain = Plain.of_model items in
  let setting = setting faults plain items in
  let all = regions faults items in
  let t = { plain; setting; balls = Hashtbl.create 4; declared = shapes faults plain all items; faults } in
  find_inline t items;
  Names.iter (fun _ s -> cut t s) t.declared;
  let refined = List.concat (List.map (item t) items) in
  match List.sort_uniq Diag.compare !faults with
  | [] -> Ok (List.append (balls t) refined, notes t items)
  | faults -> Error (List.filteri (fun i _ -> i < Parse.max_errors) faults)
