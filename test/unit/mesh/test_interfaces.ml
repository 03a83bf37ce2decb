(* Interfaces of prototypes, of VRML and of X3D: a contradiction, in one file or with another, is refused. *)
open Scc_mesh

let wrl text = "#VRML V2.0 utf8\n" ^ text
let x3d text = "<X3D><Scene>" ^ text ^ "</Scene></X3D>"
let box n = Printf.sprintf "{ Shape { geometry Box { size %d %d %d } } }" n n n

let declare ?(fields = "") name n =
  Printf.sprintf
    "<ProtoDeclare name='%s'><ProtoInterface>%s</ProtoInterface><ProtoBody><Shape><Box size='%d %d %d'/></Shape>\
     </ProtoBody></ProtoDeclare>"
    name fields n n n

let extern ?(fields = "") name url =
  Printf.sprintf "<ExternProtoDeclare name='%s' url='%s'>%s</ExternProtoDeclare>" name url fields

let field ?(more = "") access kind name =
  Printf.sprintf "<field name='%s' type='%s' accessType='%s' %s/>" name kind access more

let sized = field "inputOutput" "SFVec3f" "s" ^ field "inputOnly" "SFTime" "go"

let files =
  [
    ("sizes.wrl", wrl ("PROTO P [ exposedField SFVec3f s 2 2 2 eventIn SFTime go ] " ^ box 2));
    ("sizes.x3d", x3d (declare ~fields:sized "P" 2));
    (* The first of either is in another file. *)
    ("second.wrl", wrl ("EXTERNPROTO E [ ] \"sizes.wrl#P\"\nPROTO Q [ ] " ^ box 4));
    ("second.x3d", x3d (extern "E" "sizes.x3d#P" ^ declare "Q" 4));
    ("outer.wrl", wrl "EXTERNPROTO E [ ] \"sizes.wrl#P\""); ("outer.x3d", x3d (extern "E" "sizes.x3d#P"));
    ("twice.wrl", wrl ("PROTO P [ ] " ^ box 2 ^ " PROTO P [ ] " ^ box 4));
    ("a b.wrl", wrl ("PROTO P [ ] " ^ box 2)); ("c d.wrl", wrl ("PROTO P [ ] " ^ box 2));
    ("c%20d.wrl", wrl ("PROTO P [ ] " ^ box 2 ^ "PROTO %50 [ ] " ^ box 4));
    ("a scene.wrl", wrl "Shape { geometry Box { } }");
    ("twice.x3d", x3d (declare "P" 2 ^ declare "P" 4));
  ]

let file path = Option.to_result ~none:"it is not there" (List.assoc_opt path files)

(* The least x, or the fault: its file, what stands there, and its words. *)
let told ?(files = file) path text =
  match Mesh.read ~files ~path text with
  | Ok (set, _) ->
    let ends = Array.to_list (Array.map (fun (_, v) -> v.Scc_exact.Vec.x) set.ifs_vertices) in
    Scc_exact.Rat.to_string (List.fold_left Scc_exact.Rat.min Scc_exact.Rat.zero ends)
  | Error d ->
    let source = if String.equal d.span.file path then text else Result.get_ok (files d.span.file) in
    Printf.sprintf "%s `%s`: %s" d.span.file
      (String.sub source d.span.start (d.span.stop - d.span.start))
      d.message

let ends_in found expected =
  let n = String.length expected and all = String.length found in
  all >= n && String.equal (String.sub found (all - n) n) expected

(* Each in both notations. *)
let rows =
  let use = "<ProtoInstance name='P'/>" in
  let give values =
    let one name = Printf.sprintf "<fieldValue name='%s' value='1 1 1'/>" name in
    "<ProtoInstance name='P'>" ^ String.concat "" (List.map one values) ^ "</ProtoInstance>"
  in
  let outer fields file rest = Printf.sprintf "EXTERNPROTO P [ %s ] \"%s\" %s" fields file rest in
  let outer_xml fields file rest = extern ~fields "P" file ^ rest in
  let s = field "inputOutput" "SFVec3f" "s" in
  [
    ("the first PROTO", outer "" "second.wrl" "P { }", outer_xml "" "second.x3d" use, "-2");
    ("the first PROTO, mixed", outer "" "second.x3d" "P { }", outer_xml "" "second.wrl" use, "-2");
    ("an EXTERNPROTO by its name", outer "" "second.wrl#E" "P { }", outer_xml "" "second.x3d#E" use, "-1");
    ("no PROTO", outer "" "outer.wrl" "P { }", outer_xml "" "outer.x3d" use, "has no PROTO of its own");
    ( "a field twice", "PROTO P [ field SFInt32 a 1 field SFInt32 a 2 ] " ^ box 2,
      declare ~fields:(field "inputOutput" "SFInt32" "a" ^ field "inputOnly" "SFInt32" "a") "P" 2,
      "`a`: `a` is there twice" );
    ( "a field twice, outside", outer "field SFVec3f s eventIn SFTime s" "sizes.wrl" "",
      outer_xml (s ^ s) "sizes.x3d" "", "`s`: `s` is there twice" );
    ( "a value twice", "PROTO P [ field SFVec3f s 1 1 1 ] " ^ box 2 ^ " P { s 1 1 1 s 2 2 2 }",
      declare ~fields:s "P" 2 ^ give [ "s"; "s" ], "`s`: `s` is there twice" );
    ( "a value twice, outside", outer "field SFVec3f s" "sizes.wrl" "P { s 1 1 1 s 2 2 2 }",
      outer_xml s "sizes.x3d" (give [ "s"; "s" ]), "`s`: `s` is there twice" );
    ( "PROTO and PROTO", "PROTO P [ ] " ^ box 2 ^ " PROTO P [ ] " ^ box 4, declare "P" 2 ^ declare "P" 4,
      "`P`: the prototype `P` is declared twice" );
    ( "PROTO and EXTERNPROTO", "PROTO P [ ] " ^ box 2 ^ outer "" "sizes.wrl" "",
      declare "P" 2 ^ outer_xml "" "sizes.x3d" "", "`P`: the prototype `P` is declared twice" );
    ( "EXTERNPROTO and EXTERNPROTO", outer "" "sizes.wrl" (outer "" "sizes.wrl" ""),
      outer_xml "" "sizes.x3d" (outer_xml "" "sizes.x3d" ""), "`P`: the prototype `P` is declared twice" );
    ( "twice, from outside", outer "" "twice.wrl#P" "P { }", outer_xml "" "twice.x3d#P" use,
      "`P`: the prototype `P` is declared twice" );
    ( "the same in a body", "PROTO P [ ] { PROTO Q [ ] " ^ box 2 ^ " Q { } } PROTO Q [ ] { P { } } Q { }",
      "<ProtoDeclare name='P'><ProtoBody>" ^ declare "Q" 2 ^ "<ProtoInstance name='Q'/></ProtoBody></ProtoDeclare>"
      ^ declare "Q" 4 ^ use, "-1" );
    ( "a node of the format", "PROTO Box [ ] { Shape { geometry Sphere { } } }", declare "Box" 2,
      "`Box`: `Box` is a node of the format, and no name for a prototype" );
    ( "a node of the format, outside", "EXTERNPROTO Inline [ ] \"sizes.wrl\"", extern "Inline" "sizes.x3d",
      "is a node of the format, and no name for a prototype" );
    ("a field that fits", outer "field SFVec3f s" "sizes.wrl" "P { }", outer_xml s "sizes.x3d" use, "-1");
    ( "an event of a field", outer "eventIn SFVec3f set_s eventOut SFVec3f s_changed" "sizes.wrl" "P { }",
      outer_xml (field "inputOnly" "SFVec3f" "set_s") "sizes.x3d" use, "-1" );
    ( "no such field", outer "field SFVec3f t" "sizes.wrl" "P { }",
      outer_xml (field "inputOutput" "SFVec3f" "t") "sizes.wrl" use,
      "`t`: the prototype in the file `sizes.wrl` has no field `t`" );
    ( "another type", outer "field SFFloat s" "sizes.x3d" "P { }",
      outer_xml (field "inputOutput" "SFFloat" "s") "sizes.x3d" use,
      "`s`: `s` is of the type SFFloat here, and of the type SFVec3f in the file `sizes.x3d`" );
    ( "an event elsewhere", outer "field SFTime go" "sizes.x3d" "P { }",
      outer_xml (field "inputOutput" "SFTime" "go") "sizes.x3d" use,
      "`go`: `go` is a field with a value here, and an event that comes in in the file `sizes.x3d`" );
    ( "not declared here", outer "" "sizes.wrl" "P { s 1 1 1 }", outer_xml "" "sizes.x3d" (give [ "s" ]),
      "`s`: the prototype `P` has no field `s` that has a value" );
    ( "a value for an event", outer "eventIn SFTime go" "sizes.wrl" "P { go 1 }",
      outer_xml (field "inputOnly" "SFTime" "go") "sizes.x3d" (give [ "go" ]),
      "`go`: the prototype `P` has no field `go` that has a value" );
    ( "a value outside", outer "field SFVec3f s 1 1 1" "sizes.wrl" "",
      outer_xml (field ~more:"value='1 1 1'" "inputOutput" "SFVec3f" "s") "sizes.x3d" "",
      "has no value: the other file gives it one" );
    ("an address", outer "" "a%20b.wrl#%50" "P { }", outer_xml "" "a%20b.wrl#%50" use, "-1");
    ("an address, in words", outer "" "a b.wrl" "P { }", outer_xml "" "\"a b.wrl\"" use, "-1");
    ("as it stands", outer "" "c%20d.wrl#%50" "P { }", outer_xml "" "c%20d.wrl#%50" use, "-2");
    ("an address above", outer "" "%2E%2e/a.wrl" "P { }", outer_xml "" "%2E%2e/a.wrl" use,
     "only files beside it are read, by a name without `..`, drive or address");
    ( "an Inline", "Inline { url \"a%20scene.wrl\" }", "<Inline url='\"a%20scene.wrl\"'/>", "-1" );
    ( "another name", outer "" "second.wrl#No" "P { }", outer_xml "" "second.wrl#No" use,
      "the file `second.wrl` has no prototype of the name `No`" );
  ]

let check (what, vrml, xml, expected) =
  let test () =
    let one path text =
      let found = told path text in
      Alcotest.(check string) path expected (if ends_in found expected then expected else found)
    in
    one "t.wrl" (wrl vrml);
    one "t.x3d" (x3d xml)
  in
  Alcotest.test_case what `Quick test

(* What helps is another thing for each fault. *)
let hints () =
  let of_file text rest =
    let files path = if path = "o.wrl" then Ok (wrl text) else Error "it is not there" in
    match Mesh.read ~files ~path:"t.wrl" (wrl rest) with
    | Error d -> Option.value d.hint ~default:""
    | Ok _ -> "it is read"
  in
  let extern = "EXTERNPROTO P [ ] \"o.wrl#P\" " in
  let found =
    [
      of_file extern (extern ^ "P { }");
      of_file ("PROTO A [ ] " ^ box 2 ^ "PROTO B [ ] " ^ box 2) (extern ^ "P { }");
      of_file ("UNIT length mm 0.001 PROTO P [ ] " ^ box 2) (extern ^ "P { }");
      of_file "" "EXTERNPROTO P [ ] \"none.wrl\" P { }";
      of_file "Inline { url \"o.wrl\" }" "Inline { url \"o.wrl\" }";
    ]
  in
  Alcotest.(check (list string)) "hints"
    [
      "end the cycle: write the address of the file that has the body of the prototype";
      "write one of the names that are there: `A`, `B`";
      "write the lengths in both files in one unit, and state it in both";
      "put the declaration of the prototype into this file, or that file beside this one";
      "remove one of the Inlines that lead from the file to itself";
    ]
    found

let suite =
  ("interfaces", [ ("both", List.map check rows); ("hints", [ Alcotest.test_case "each its own" `Quick hints ]) ])
