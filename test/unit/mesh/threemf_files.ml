(* The tetrahedron of the tests as 3MF, whole and with faults. *)

(* {1 ZIP} *)

type part = { name : string; how : int; flags : int; size : int; sum : int32; packed : string }

let crc text = Zlib.update_crc_string 0l text 0 (String.length text)

let deflated text =
  let out = Buffer.create 1000 and position = ref 0 in
  let give bytes =
    let n = min (Bytes.length bytes) (String.length text - !position) in
    Bytes.blit_string text !position bytes 0 n;
    position := !position + n;
    n
  in
  Zlib.compress ~header:false give (fun bytes n -> Buffer.add_subbytes out bytes 0 n);
  Buffer.contents out

let part ?(deflate = true) name text =
  let packed = if deflate then deflated text else text in
  { name; how = (if deflate then 8 else 0); flags = 0; size = String.length text; sum = crc text; packed }

(* [wide]: lengths are eight bytes each, in extra fields of so many in all, as in ZIP64. *)
let zip ?(comment = "") ?count ?wide parts =
  let out = Buffer.create 1000 and directory = Buffer.create 1000 in
  let u16 = Buffer.add_uint16_le and u32 b n = Buffer.add_int32_le b (Int32.of_int n) in
  let extra p =
    let b = Buffer.create 20 in
    List.iter (u16 b) [ 9; 2; 7; 1; 16 ];
    List.iter (u32 b) [ p.size; 0; String.length p.packed; 0 ];
    match wide with None -> "" | Some bytes -> Buffer.sub b 0 bytes
  in
  let common b p =
    let length n = if Option.is_some wide then 0xFFFFFFFF else n in
    List.iter (u16 b) [ 20; p.flags; p.how; 0; 0 ];
    Buffer.add_int32_le b p.sum;
    u32 b (length (String.length p.packed));
    u32 b (length p.size);
    List.iter (u16 b) [ String.length p.name; String.length (extra p) ]
  in
  let add p =
    let at = Buffer.length out in
    u32 out 0x04034B50;
    common out p;
    Buffer.add_string out (p.name ^ extra p ^ p.packed);
    u32 directory 0x02014B50;
    u16 directory 20;
    common directory p;
    List.iter (u16 directory) [ 0; 0; 0; 0; 0 ];
    u32 directory at;
    Buffer.add_string directory (p.name ^ extra p)
  in
  List.iter add parts;
  let start = Buffer.length out in
  Buffer.add_buffer out directory;
  let count = Option.value count ~default:(List.length parts) in
  u32 out 0x06054B50;
  List.iter (u16 out) [ 0; 0; count; count ];
  List.iter (u32 out) [ Buffer.length directory; start ];
  u16 out (String.length comment);
  Buffer.add_string out comment;
  Buffer.contents out

(* {1 Models} *)

let rels =
  "<?xml version='1.0'?><Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'>\
   <Relationship Target='/a.png' Id='i' Type='http://example.org/picture'/><Relationship \
   Target='/3D/3dmodel.model' Id='r' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/>\
   </Relationships>"

let vertices =
  "<vertices><vertex x='0' y='0' z='0'/><vertex x='1.25' y='0' z='0'/><vertex x='0' y='1e0' z='0'/>\
   <vertex x='0' y=' 0 ' z='2.'/></vertices>"

let triangles =
  "<triangles><triangle v1='0' v2='2' v3='1'/><triangle v1='0' v2='1' v3='3'/><triangle v1='0' v2='3' v3='2'/>\
   <triangle v1='1' v2='2' v3='3'/></triangles>"

let mesh = "<mesh>" ^ vertices ^ triangles ^ "</mesh>"

let thing ?(kind = "model") id body = Printf.sprintf "<object id='%s' type='%s'>%s</object>" id kind body

let component ?(more = "") id = Printf.sprintf "<component objectid='%s' %s/>" id more
let components list = "<components>" ^ String.concat "" list ^ "</components>"
let moved place id = component ~more:(Printf.sprintf "transform='%s'" place) id

let model ?(head = "") ?(build = "<item objectid='1'/>") things =
  Printf.sprintf
    "<?xml version='1.0' encoding='UTF-8'?>\n<model unit='inch' xmlns:m='http://example.org/m' \
     xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02' %s><metadata name='Title'>a &amp; \
     b</metadata><resources><m:more><object/></m:more>%s</resources><build>%s</build></model>"
    head (String.concat "" things) build

(* As it is: what a library of another version makes of it would end elsewhere. *)
let first = part ~deflate:false "_rels/.rels"
let package ?(rels = rels) model = zip [ first rels; part "3D/3dmodel.model" model ]
let whole = package (model [ thing "1" mesh ])

(* A quarter turn about z, moved, and the inverse of both. *)
let turned_back =
  let turn = "0 1 0 -1 0 0 0 0 1 5 0 -1.5" and back = "0 -1 0\t1 0 0 0 0 1  0 5 1.5" in
  package
    (model
       ~build:(Printf.sprintf "<item objectid='3' transform='%s'/>" back)
       [
         thing "1" mesh; thing ~kind:"support" "9" mesh; thing "2" (components [ component "1" ]);
         thing "3" (components [ moved turn "2"; moved turn "9" ]);
       ])

let mirrored =
  package (model ~build:"<item objectid='1' transform='-1 0 0 0 1 0 0 0 1 0 0 0'/>" [ thing "1" mesh ])

let production = "xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06' requiredextensions='p'"

(* The solid is in a part of its own. *)
let elsewhere ?things ?(build = "<item objectid='2'/>") ?(part_unit = "inch") path =
  let there = Printf.sprintf "p:path='%s'" path in
  let things = Option.value things ~default:[ thing "2" (components [ component ~more:there "1" ]) ] in
  let other =
    Printf.sprintf
      "<model unit='%s' xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'><resources>%s\
       </resources><build/></model>"
      part_unit (thing "1" mesh)
  in
  zip
    [
      first rels; part "3D/3dmodel.model" (model ~head:production ~build things); part "3D/Objects/a.model" other;
    ]

let files =
  [
    ("3MF", "t.3mf", whole); ("3MF told by its text", "t", whole);
    ("3MF, stored", "t.3mf",
     zip ~comment:"PK\005\006 is no end here, nor is this"
       [ part ~deflate:false "3d/3DMODEL.model" (model [ thing "1" mesh ]); first rels ]);
    ("3MF, wide lengths", "t.3mf",
     zip ~wide:26 [ first rels; part "3D/3dmodel.model" (model [ thing "1" mesh ]) ]);
    ("3MF, a byte order mark", "t.3mf", package ("\xEF\xBB\xBF" ^ model [ thing "1" mesh ]));
    ("3MF, turned and back", "t.3mf", turned_back);
    ("3MF, a harmless extension", "t.3mf",
     package
       (model
          ~head:
            "xmlns:c='http://schemas.microsoft.com/3dmanufacturing/material/2015/02' requiredextensions=' c '"
          [ thing "1" mesh ]));
    ("3MF, parts of other programs", "t.3mf",
     package
       (model
          ~head:"xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06' requiredextensions='p'"
          [ thing "1" mesh ]));
    ("3MF, an object in another part", "t.3mf", elsewhere "/3D/Objects/a.model");
    ("3MF, an item in another part", "t.3mf",
     elsewhere ~things:[] ~build:"<item p:path='/3D/Objects/a.model' objectid='1' p:UUID='u'/>" "");
  ]

(* Models, to be packed when they are damaged. *)
let models =
  [
    model [ thing "1" mesh ];
    model ~build:"<item objectid='2'/>"
      [ thing "1" mesh; thing "2" (components [ moved "1 0 0 0 1 0 0 0 1 2 3 4" "1" ]) ];
  ]

let packed model = package model

(* {1 Faults} *)

let doubling =
  let double i = thing (string_of_int i) (components [ component (string_of_int (i - 1)); component "1" ]) in
  let twice i = thing (string_of_int i) (components (List.init 2 (fun _ -> component (string_of_int (i - 1))))) in
  package
    (model ~build:"<item objectid='60'/>" (thing "1" mesh :: double 2 :: List.init 58 (fun i -> twice (i + 3))))

(* Numbers that get longer with each of many. *)
let growing =
  let longer id = moved "1.3 0 0 0 1 0 0 0 1 .1 0 0" id in
  let one i = thing (string_of_int i) (components [ longer (string_of_int (i - 1)) ]) in
  package (model ~build:"<item objectid='3000'/>" (thing "1" mesh :: List.init 2999 (fun i -> one (i + 2))))

let with_part change = zip [ first rels; change (part "3D/3dmodel.model" (model [ thing "1" mesh ])) ]
let of_mesh text = package (model [ thing "1" text ])

let bad =
  let fault name text = ("3MF, " ^ name, "t.3mf", text, "1:1 SC0320") in
  let anywhere name text place = ("3MF, " ^ name, "t.3mf", text, place ^ " SC0320") in
  [
    fault "no ZIP" "PK\003\004"; fault "nothing" ""; fault "cut short" (String.sub whole 0 200);
    fault "no parts" (zip []);
    fault "no relationships" (zip [ part "3D/3dmodel.model" (model [ thing "1" mesh ]) ]);
    fault "no model" (zip [ first rels ]);
    fault "no relationship to a model" (package ~rels:"<Relationships/>" (model []));
    anywhere "a directory that lies" (zip ~count:9 [ first rels ]) "1:407";
    anywhere "ZIP64" (zip ~count:0xFFFF []) "1:1";
    anywhere "wide lengths that are missing" (zip ~wide:18 [ first rels ]) "1:443";
    anywhere "a part twice" (zip [ first rels; part "_RELS/.rels" rels ]) "1:351";
    anywhere "encrypted" (with_part (fun p -> { p with flags = 1 })) "1:351";
    anywhere "another method" (with_part (fun p -> { p with how = 14 })) "1:351";
    anywhere "a checksum" (with_part (fun p -> { p with sum = 1l })) "1:351";
    anywhere "shorter" (with_part (fun p -> { p with size = p.size + 1 })) "1:351";
    anywhere "longer" (with_part (fun p -> { p with size = p.size - 1 })) "1:351";
    anywhere "no deflated data" (with_part (fun p -> { p with packed = "\255\255" ^ p.packed })) "1:351";
    anywhere "a bomb" (with_part (fun _ -> part "3D/3dmodel.model" (String.make 3_000_000 ' '))) "1:351";
    anywhere "a bomb that lies" (with_part (fun p -> { p with size = 0x7FFFFFFF })) "1:351";
    fault "no XML" (package "PK"); fault "a tag that does not end" (package "<model");
    fault "a document type" (package ("<!DOCTYPE model [<!ENTITY a 'b'>]>" ^ model [ thing "1" mesh ]));
    fault "an entity" (of_mesh "&lol;");
    fault "too deep" (package (String.concat "" (List.init 2000 (fun _ -> "<a>"))));
    fault "another root" (package "<model/>"); fault "two roots" (package (model [ thing "1" mesh ] ^ "<a/>"));
    fault "no Latin" (package (model ~head:"a='\xE9'" [ thing "1" mesh ]));
    fault "an extension" (package (model ~head:"requiredextensions='m'" [ thing "1" mesh ]));
    fault "an extension without its name" (package (model ~head:"requiredextensions='q'" [ thing "1" mesh ]));
    fault "nothing to be built" (package (model ~build:"" [ thing "1" mesh ]));
    fault "no such object" (package (model ~build:"<item objectid='2'/>" [ thing "1" mesh ]));
    fault "an object twice" (package (model [ thing "1" mesh; thing "1" mesh ]));
    fault "an object in itself" (package (model [ thing "1" (components [ component "1" ]) ]));
    fault "two objects in each other"
      (package (model [ thing "1" (components [ component "2" ]); thing "2" (components [ component "1" ]) ]));
    fault "an object of the wrong kind" (package (model [ thing ~kind:"other" "1" mesh ]));
    fault "a part of a model elsewhere"
      (package (model ~build:"<item objectid='1' m:path='/3D/b.model'/>" [ thing "1" mesh ]));
    fault "a part that is not there" (elsewhere "/3D/Objects/b.model");
    fault "a part that names itself" (elsewhere "/3D/3dmodel.model");
    fault "a part by a short path" (elsewhere "3D/Objects/a.model");
    fault "a part in another unit" (elsewhere ~part_unit:"meter" "/3D/Objects/a.model");
    fault "beams"
      (of_mesh ("<mesh>" ^ vertices ^ triangles
                ^ "<b:beamlattice xmlns:b='http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02'/>"
                ^ "</mesh>"));
    fault "an item that is not printed"
      (package (model ~build:"<item objectid='1' printable='0'/>" [ thing "1" mesh ]));
    fault "two shapes" (of_mesh (mesh ^ mesh));
    fault "a doubling of components" doubling; fault "growing numbers" growing;
    fault "an unknown type" (package (model [ thing ~kind:"solid" "1" mesh ]));
    fault "an unknown unit" (elsewhere ~part_unit:"yard" "/3D/Objects/a.model");
    fault "eleven numbers" (package (model [ thing "1" mesh; thing "2" (components [ moved "1 2" "1" ]) ]));
    fault "no number"
      (package (model [ thing "1" mesh; thing "2" (components [ moved "1 0 0 0 1 0 0 0 1 0 0 x" "1" ]) ]));
    fault "no coordinate" (of_mesh "<mesh><vertices><vertex x='1' y='2'/></vertices></mesh>");
    fault "infinity" (of_mesh "<mesh><vertices><vertex x='1' y='2' z='inf'/></vertices></mesh>");
    fault "a huge exponent" (of_mesh "<mesh><vertices><vertex x='1' y='2' z='1e999999999'/></vertices></mesh>");
    fault "triangles before vertices" (of_mesh ("<mesh>" ^ triangles ^ vertices ^ "</mesh>"));
    fault "an index out of range"
      (of_mesh ("<mesh>" ^ vertices ^ "<triangles><triangle v1='0' v2='1' v3='4'/></triangles></mesh>"));
  ]
