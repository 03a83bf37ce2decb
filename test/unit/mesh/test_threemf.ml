(* Every element and attribute of 3MF is read, still or refused; what is read is where the specification says. *)
open Scc_base
open Scc_mesh

type xml = E of string * (string * string) list * xml list

let rec text_of (E (name, attributes, inside)) =
  let attribute (name, value) = Printf.sprintf " %s='%s'" name value in
  Printf.sprintf "<%s%s>%s</%s>\n" name
    (String.concat "" (List.map attribute attributes))
    (String.concat "" (List.map text_of inside))
    name

let microsoft = "http://schemas.microsoft.com/3dmanufacturing/"
let consortium = "http://schemas.3mf.io/3dmanufacturing/"

let namespaces =
  [
    ("production", microsoft ^ "production/2015/06"); ("material", microsoft ^ "material/2015/02");
    ("alternatives", microsoft ^ "production/alternatives/2021/04");
    ("trianglesets", microsoft ^ "trianglesets/2021/07"); ("beamlattice", microsoft ^ "beamlattice/2017/02");
    ("balls", microsoft ^ "beamlattice/balls/2020/07"); ("slice", microsoft ^ "slice/2015/07");
    ("securecontent", microsoft ^ "securecontent/2019/04"); ("volumetric", consortium ^ "volumetric/2022/01");
    ("implicit", consortium ^ "implicit/2023/12"); ("displacement", consortium ^ "displacement/2023/10");
    ("booleanoperations", consortium ^ "booleanoperations/2023/07"); ("frob", "http://example.org/frob");
  ]

(* {1 A model with every element of the core specification} *)

let vertex (x, y, z) = E ("vertex", [ ("x", x); ("y", y); ("z", z) ], [])
let triangle (a, b, c) = E ("triangle", [ ("v1", a); ("v2", b); ("v3", c) ], [])
let metadata = E ("metadata", [ ("name", "Title") ], [])
let group = E ("metadatagroup", [], [ metadata ])

let mesh =
  E
    ( "mesh", [],
      [
        E ("vertices", [],
           List.map vertex [ ("0", "0", "0"); ("1.25", "0", "0"); ("0", "1", "0"); ("0", "0", "2") ]);
        E ("triangles", [],
           List.map triangle [ ("0", "2", "1"); ("0", "1", "3"); ("0", "3", "2"); ("1", "2", "3") ]);
      ] )

let identity = "1 0 0 0 1 0 0 0 1 0 0 0"
let placed name more = E (name, [ ("objectid", "1"); ("transform", identity) ], more)

let model ?(head = []) ?(item = "2") inside =
  E
    ( "model",
      (("xmlns", microsoft ^ "core/2015/02") :: List.map (fun (p, uri) -> ("xmlns:" ^ p, uri)) namespaces)
      @ (("unit", "meter") :: head),
      [
        metadata; E ("resources", [], inside);
        E ("build", [], [ E ("item", [ ("objectid", item); ("transform", identity) ], [ group ]) ]);
      ] )

let whole =
  model
    [
      E ("basematerials", [ ("id", "7") ], [ E ("base", [ ("name", "a"); ("displaycolor", "#000000") ], []) ]);
      E ("object", [ ("id", "1"); ("type", "model") ], [ group; mesh ]);
      E ("object", [ ("id", "2") ], [ E ("components", [], [ placed "component" [] ]) ]);
    ]

(* {1 Changes of the first element of a name} *)

let change name f root =
  let changed = ref false in
  let rec go (E (n, attributes, inside) as xml) =
    if (not !changed) && String.equal n name then (
      changed := true;
      f xml)
    else
      let inside = List.concat_map go inside in
      [ E (n, attributes, inside) ]
  in
  match go root with
  | [ changed_root ] when !changed -> changed_root
  | _ -> Alcotest.fail ("no element " ^ name)

let with_attribute name value =
  change name (fun (E (n, attributes, inside)) ->
      [ E (n, List.remove_assoc (fst value) attributes @ [ value ], inside) ])

let with_element name inner = change name (fun (E (n, a, inside)) -> [ E (n, a, inner :: inside) ])
let without name = change name (fun _ -> [])

type found = Same of string list | Other | Fault of string * string

let read_text text = Mesh.read ~files:Beside.none ~path:"t.3mf" (Threemf_files.packed text)

let alone =
  match read_text (text_of whole) with
  | Ok (set, []) -> Scene_files.describe set
  | Ok _ -> Alcotest.fail "the whole model has a warning"
  | Error d -> Alcotest.fail d.Diag.message

let found xml =
  match read_text (text_of xml) with
  | Error (d : Diag.t) -> Fault (d.code, d.message)
  | Ok (set, warnings) when Scene_files.describe set = alone ->
    Same (List.map (fun (d : Diag.t) -> d.code) warnings)
  | Ok _ -> Other

let show = function
  | Same codes -> "the same " ^ String.concat " " codes
  | Other -> "another solid"
  | Fault (code, message) -> code ^ ": " ^ message

let expect what expected xml = Alcotest.(check string) what expected (show (found xml))
let still what = expect (what ^ " changes nothing") "the same "

(* The message has the part and the line. *)
let refused what xml =
  match found xml with
  | Fault ("SC0320", message) when String.starts_with ~prefix:"`3D/3dmodel.model`, line " message -> ()
  | other -> Alcotest.fail (Printf.sprintf "%s: %s" what (show other))

(* {1 The list} *)

let rows = Test_gltf.lines "threemf_names.txt"
let prefixed space name = if space = "core" then name else space ^ ":" ^ name

let fitting = function
  | "id" | "pid" | "pindex" | "p1" | "p2" | "p3" -> "7"
  | "modelresolution" -> "fullres"
  | _ -> "a"

let check_row row () =
  match row with
  | [ "element"; "core"; name; _; "read" ] -> (
      match found (without name whole) with
      | Same _ -> Alcotest.fail (name ^ " is not read")
      | Other | Fault _ -> ())
  | [ "element"; space; name; within; mark ] ->
    let added = with_element within (E (prefixed space name, [ ("odd", "odd") ], [])) whole in
    (if mark = "still" then still else refused) name added
  | [ "attribute"; space; name; element; mark ] ->
    let with_value value = with_attribute element (prefixed space name, value) whole in
    if mark = "still" then List.iter (fun v -> still name (with_value v)) [ fitting name; "odd"; "" ]
    else refused name (with_value "odd")
  | _ -> Alcotest.fail (String.concat " " row)

(* An element or an attribute that no specification has is left out with a warning. *)
let check_unknown element () =
  let warned what = expect what "the same SC0324" in
  warned (element ^ ", an element") (with_element element (E ("frob", [], [])) whole);
  warned (element ^ ", another element") (with_element element (E ("frob:frob", [], [])) whole);
  warned (element ^ ", an attribute") (with_attribute element ("frob", "1") whole);
  warned (element ^ ", another attribute") (with_attribute element ("frob:frob", "1") whole)

let complete () =
  let mark = function
    | Threemf_table.Read -> "read"
    | Still -> "still"
    | Left_out | Unread _ -> Alcotest.fail "the core has neither"
  in
  let listed what table =
    List.concat_map (fun (e, own) -> List.map (fun (n, m) -> String.concat " " [ what; n; e; mark m ]) own) table
  in
  let checked = List.map fst Threemf_table.elements in
  let written = function
    | [ what; "core"; name; within; mark ] when List.mem within checked ->
      Some (String.concat " " [ what; name; within; mark ])
    | _ -> None
  in
  let sorted = List.sort String.compare in
  Alcotest.(check (list string)) "the tables"
    (sorted (List.filter_map written rows))
    (sorted (listed "element" Threemf_table.elements @ listed "attribute" Threemf_table.attributes))

(* {1 What is read} *)

let object_ ?(more = []) id inside = E ("object", ("id", id) :: more, inside)
let components list = E ("components", [], list)
let component ?(transform = identity) id = E ("component", [ ("objectid", id); ("transform", transform) ], [])
let lowres = ("alternatives:modelresolution", "lowres")
let full = "(0, 0, 0) (5/4, 1, 2) solid"
let line n what = Printf.sprintf "error `3D/3dmodel.model`, line %d: %s" n what

let effects =
  [
    ("a mirror", with_attribute "item" ("transform", "-1 0 0 0 1 0 0 0 1 0 0 0") whole,
     "(-5/4, 0, 0) (0, 1, 2) solid");
    ("two mirrors",
     with_attribute "component" ("transform", "1 0 0 0 -1 0 0 0 1 0 0 0")
       (with_attribute "item" ("transform", "-1 0 0 0 1 0 0 0 1 0 0 0") whole), "(-5/4, -1, 0) (0, 0, 2) solid");
    ("rows are of vectors", with_attribute "item" ("transform", "1 1 0 0 1 0 0 0 1 3 0 0") whole,
     "(3, 0, 0) (17/4, 5/4, 2) solid");
    ("a unit is not applied", with_attribute "model" ("unit", "micron") whole, full);
    ("numbers with zeros", with_attribute "item" ("objectid", "002") whole, full);
    ("a support beside it",
     model ~item:"3"
       [
         object_ "1" [ mesh ]; object_ ~more:[ ("type", "support") ] "2" [ mesh ];
         object_ "3" [ components [ component "1"; component ~transform:"1 0 0 0 1 0 0 0 1 9 9 9" "2" ] ];
       ],
     full ^ " SC0324");
    ("a surface", with_attribute "object" ("type", "surface") whole, full);
    ("no such kind", with_attribute "object" ("type", "other") whole,
     line 22 "the object `1` is of the type `other`, and is not to be built");
    ("the full resolution", with_attribute "object" ("alternatives:modelresolution", "fullres") whole, full);
    ("a low resolution", with_attribute "object" lowres whole,
     line 4 "the object `1` is not meant to be made: its resolution is `lowres`");
    ("vertices twice", with_element "mesh" (E ("vertices", [], [])) whole,
     line 7 "the element `vertices` is in `mesh` twice");
    ("triangles twice", change "triangles" (fun x -> [ x; x ]) whole,
     line 16 "the element `triangles` is in `mesh` twice");
    ("resources twice", with_element "model" (E ("resources", [], [])) whole,
     line 3 "the element `resources` is in `model` twice");
    ("builds twice", change "build" (fun x -> [ x; x ]) whole, line 26 "the element `build` is in `model` twice");
    ("an attribute twice", change "vertex" (fun (E (n, a, i)) -> [ E (n, ("x", "5") :: a, i) ]) whole,
     line 6 "the attribute `x` is there twice");
    ("an identifier", with_attribute "object" ("id", "one") whole,
     line 4 "`id` is to be an integer, and not `one`");
    ("not for a printer", with_attribute "item" ("printable", "0") whole,
     line 22 "an item that is not to be printed: remove it, or make it printable");
    ("an object in itself",
     model ~item:"1" [ object_ "1" [ components [ component "1" ] ] ],
     line 2 "there is no object `1` before this");
  ]

let message text =
  match read_text text with
  | Error d -> d.Diag.message
  | Ok _ -> "read"

let check_effect (what, xml, expected) =
  let test () =
    let got = Test_scenes.extent "t.3mf" (Threemf_files.packed (text_of xml)) in
    Alcotest.(check string) what expected got
  in
  Alcotest.test_case what `Quick test

let packages () =
  let one = Threemf_files.rels in
  let kind = microsoft ^ "2013/01/3dmodel" in
  let relation = Printf.sprintf "<Relationship Target='/3D/b.model' Id='q' Type='%s'/>" kind in
  let n = String.length one - String.length "</Relationships>" in
  let rels = String.sub one 0 n ^ relation ^ "</Relationships>" in
  (match Mesh.read ~files:Beside.none ~path:"t.3mf" (Threemf_files.package ~rels (text_of whole)) with
   | Error d ->
     let expected = "`_rels/.rels`, line 1: the package begins with two models" in
     Alcotest.(check string) "two models" expected d.Diag.message
   | Ok _ -> Alcotest.fail "two models are read");
  Alcotest.(check string) "an encrypted part" "`3D/3dmodel.model`, line 1: the part is encrypted"
    (message ("%3McF" ^ String.make 40 '\001'))

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ( "threemf",
    [
      ("names", case "the tables" complete :: List.map (fun r -> case (String.concat " " r) (check_row r)) rows);
      ("unknown", List.map (fun (e, _) -> case e (check_unknown e)) Threemf_table.elements);
      ("places", List.map check_effect effects @ [ case "packages" packages ]);
    ] )
