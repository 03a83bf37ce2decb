open Scc_base

type node = { kind : Text.word; name : string option; fields : (Text.word * value) list }
and value = Words of Text.word list | Nodes of node list

type change = { at : Text.word; target : target }
and target = Field of node * string | Instance | Nobody of string

type route = { place : Text.word; from : string; node : string; field : string }

type file = { nodes : node list; changes : change list; length : Scc_exact.Rat.t }

exception Refused of Diag.t

let ok = function Ok value -> value | Error d -> raise (Refused d)

let bad ~path word fmt = Printf.ksprintf (fun what -> ok (Text.error ~path word "%s" what)) fmt

let unread ~path (w : Text.word) ~hint fmt =
  let span = Span.make ~file:path ~start:w.start ~stop:(w.start + String.length w.text) in
  Printf.ksprintf (fun what -> raise (Refused (Diag.error Code.mesh_format span ~hint "%s" what))) fmt

let max_depth = 1000

type names = {
  complete : (string, node) Hashtbl.t;
  opened : (string, unit) Hashtbl.t;
  instances : (string, unit) Hashtbl.t;
}

let names () = { complete = Hashtbl.create 16; opened = Hashtbl.create 16; instances = Hashtbl.create 16 }
let opening names name = Option.iter (fun name -> Hashtbl.add names.opened name ()) name

let closing names node =
  let close name =
    Hashtbl.remove names.opened name;
    Hashtbl.remove names.instances name;
    Hashtbl.replace names.complete name node
  in
  Option.iter close node.name

let used ~path names (w : Text.word) =
  if Hashtbl.mem names.opened w.text then bad ~path w "the node %s is used inside of itself" (Text.quote w.text)
  else
    match Hashtbl.find_opt names.complete w.text with
    | Some node -> node
    | None -> bad ~path w "no node before this has the name %s" (Text.quote w.text)

let instance names node =
  closing names node;
  Option.iter (fun name -> Hashtbl.replace names.instances name ()) node.name

let changes names routes =
  let one { place = at; from; node; field } =
    match Hashtbl.find_opt names.complete node with
    | None -> { at; target = Nobody node }
    | Some _ when not (Hashtbl.mem names.complete from) -> { at; target = Nobody from }
    | Some _ when Hashtbl.mem names.instances node -> { at; target = Instance }
    | Some found -> { at; target = Field (found, field) }
  in
  List.map one routes

(* {1 Prototypes} *)

type fields = (string * value option) list
type access = In | Out | Field | Exposed | Unsaid
type declared = { field : Text.word; type_ : string; access : access }
type interface = declared list

let access_name = function
  | In -> "an event that comes in"
  | Out -> "an event that goes out"
  | Field | Exposed | Unsaid -> "a field with a value"

let type_of (interface : interface) name =
  match List.find_opt (fun d -> String.equal d.field.text name) interface with Some d -> d.type_ | None -> ""

type elsewhere = { path : string; name : string; interface : interface; at : Text.word; urls : string list }
type 'body prototype =
  | Elsewhere of elsewhere
  | Inside
  | Own of { interface : interface; fields : fields; body : 'body }

let within (name : string) known = if List.mem_assoc name known then known else (name, Inside) :: known

let inside ~path w name = bad ~path w "the prototype %s is used inside of itself" (Text.quote name)

let check_twice ~path words =
  let met = Hashtbl.create 16 in
  let one (w : Text.word) =
    if Hashtbl.mem met w.text then bad ~path w "`%s` is there twice" w.text;
    Hashtbl.replace met w.text ()
  in
  List.iter one words

let check_interface ~path interface = check_twice ~path (List.map (fun d -> d.field) interface)

(* The nodes of VRML 97, which are in each version of X3D too. X3D has more from version to version, and a file of
   an older one may declare them. *)
let built_in =
  String.split_on_char ' '
    "Anchor Appearance AudioClip Background Billboard Box Collision Color ColorInterpolator Cone Coordinate \
     CoordinateInterpolator Cylinder CylinderSensor DirectionalLight ElevationGrid Extrusion Fog FontStyle Group \
     ImageTexture IndexedFaceSet IndexedLineSet Inline LOD Material MovieTexture NavigationInfo Normal \
     NormalInterpolator OrientationInterpolator PixelTexture PlaneSensor PointLight PointSet \
     PositionInterpolator ProximitySensor ScalarInterpolator Script Shape Sound Sphere SphereSensor SpotLight \
     Switch Text TextureCoordinate TextureTransform TimeSensor TouchSensor Transform Viewpoint VisibilitySensor \
     WorldInfo"

type scope = (string, unit) Hashtbl.t

let scope () : scope = Hashtbl.create 8

let declare ~path scope (w : Text.word) =
  if List.mem w.text built_in then
    bad ~path w "%s is a node of the format, and no name for a prototype" (Text.quote w.text);
  if Hashtbl.mem scope w.text then bad ~path w "the prototype %s is declared twice" (Text.quote w.text);
  Hashtbl.replace scope w.text ()

let given ~path (kind : Text.word) interface fields values =
  let has_value (w : Text.word) d =
    String.equal d.field.text w.text
    && (match d.access with In | Out -> false | Field | Exposed | Unsaid -> true)
  in
  let known ((w : Text.word), _) =
    match List.assoc_opt w.text fields with
    | Some (Some _) when List.exists (has_value w) interface -> ()
    | Some (Some _) | Some None | None ->
      unread ~path w ~hint:"its fields are those in its declaration"
        "the prototype %s has no field %s that has a value" (Text.quote kind.text) (Text.quote w.text)
  in
  List.iter known values;
  check_twice ~path (List.map fst values);
  let set (name, default) =
    let own = List.find_opt (fun ((w : Text.word), _) -> String.equal w.text name) values in
    (name, match own with Some (_, value) -> Some value | None -> default)
  in
  List.map set fields

let connected ~path fields (w : Text.word) =
  match List.assoc_opt w.text fields with
  | Some value -> value
  | None -> bad ~path w "the prototype has no field %s" (Text.quote w.text)

let room ~size = ref (100_000 + (4 * size))

let spend ~path room (w : Text.word) n =
  if n > !room then bad ~path w "with this the scene would have many times the nodes that its size has room for";
  room := !room - n
