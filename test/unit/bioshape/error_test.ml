(* What is wrong with a document: codes, and places in the document itself. *)

open Scc_base
open Scc_bioshape

let xmlns = Printf.sprintf "xmlns='%s'" Namespace.uri
let around s = Printf.sprintf "<bioshape %s>\n%s\n</bioshape>" xmlns s

let found text =
  let source = Source.make ~name:"m.xml" text in
  let place (d : Diag.t) =
    let line, column = Source.position source d.span.start in
    Printf.sprintf "%s %d:%d" d.code line column
  in
  match Read.with_trivia source with
  | Ok _ -> ([], "accepted")
  | Error ds -> (List.map place ds, String.concat "" (List.map (Diag.render ~source:(fun _ -> Some source)) ds))

let contains text part =
  let n = String.length part in
  let rec at i = i + n <= String.length text && (String.equal (String.sub text i n) part || at (i + 1)) in
  at 0

let whole name text expected words =
  let test () =
    let places, told = found text in
    Alcotest.(check (list string)) told expected places;
    List.iter (fun w -> if not (contains told w) then Alcotest.failf "`%s` is not in\n%s" w told) words
  in
  Alcotest.test_case name `Quick test

(* Within a model, from line 2 on. *)
let case name text = whole name (around text)
let repeated n s = String.concat "" (List.init n (fun _ -> s))
let behaviour s = "<behaviour name='K'>" ^ s ^ "</behaviour>"

let malformed =
  [
    whole "no text" "" [ "SC0350 1:1" ] [];
    whole "no XML" "model m" [ "SC0350 1:1" ] [];
    whole "cut in a tag" "<bioshape" [ "SC0350 1:9" ] [ "ends" ];
    whole "cut in an element" ("<bioshape " ^ xmlns ^ ">\n<check name='a'>x") [ "SC0350 2:17" ] [];
    whole "two documents" (around "<let name='a' value='1'/>" ^ "\n<a/>") [ "SC0350 4:1" ] [];
    case "an end tag of another name" "<let name='a' value='1'></lot>" [ "SC0350 2:30" ] [ "let" ];
    case "an attribute twice" "<let name='a' value='1' name='b'/>" [ "SC0350 2:25" ] [ "twice" ];
    case "no quotes" "<let name=a/>" [ "SC0350 2:11" ] [];
    case "a bracket in an attribute" "<let name='a' value='1<2'/>" [ "SC0350 2:23" ] [];
    case "an ampersand" "<let name='a' value='a & b'/>" [ "SC0350 2:25" ] [];
    case "a prefix without its namespace" "<q:let name='a' value='1'/>" [ "SC0350 2:26" ] [ "`q`" ];
    case "no character" "<let name='a' value='&#0;'/>" [ "SC0350 2:22" ] [];
    case "a number too large for one" "<let name='a' value='&#99999999999999999999999;'/>" [ "SC0350 2:22" ] [];
    whole "a control character" (around "<let name='a\001'/>") [ "SC0102 2:13" ] [ "U+0001" ];
    whole "not UTF-8" (around "<!-- \xE9 -->") [ "SC0102 2:6" ] [ "UTF-8" ];
    whole "UTF-16" "\xFF\xFE<\000a\000/\000>\000" [ "SC0102 1:1" ] [];
  ]

let refused =
  [
    whole "a document type" ("<?xml version='1.0'?>\n<!DOCTYPE bioshape>\n" ^ around "") [ "SC0351 2:1" ] [];
    whole "an external entity"
      ("<!DOCTYPE bioshape [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>\n" ^ around "<let name='a' value='&x;'/>")
      [ "SC0351 1:1" ] [ "document type" ];
    whole "a bomb of entities"
      ("<!-- bomb -->\n <!DOCTYPE b [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;'>]>" ^ around "&b;")
      [ "SC0351 2:2" ] [];
    case "an entity of its own" "<let name='a' value='&x;'/>" [ "SC0351 2:22" ] [ "`&x;`" ];
    whole "another encoding" ("<?xml version='1.0' encoding='ISO-8859-1'?>" ^ around "") [ "SC0351 1:31" ]
      [ "UTF-8" ];
    whole "one that nobody knows" ("<?xml version='1.0' encoding=\"x\"?>" ^ around "") [ "SC0351 1:31" ] [];
    whole "too deep" (around (repeated 3_000 "<for>")) [ "SC0111 2:10046" ] [ "2010" ];
    whole "too deep in behaviours"
      (around (behaviour (repeated 1_100 "<choice><branch><nil/></branch><branch>")))
      [ "SC0111 2:39154" ] [];
    case "too many prefixes" (behaviour (repeated 10_001 "<delay time='1'/>" ^ "<nil/>")) [ "SC0111 2:1" ]
      [ "10000" ];
    case "too many summands" (behaviour ("<choice>" ^ repeated 10_002 "<branch><nil/></branch>" ^ "</choice>"))
      [ "SC0111 2:1" ] [ "10000" ];
    case "too deep in an expression" ("<let name='a' value='" ^ repeated 1_001 "(" ^ "'/>") [ "SC0111 2:1022" ] [];
  ]

let schema =
  [
    whole "another document" "<html/>" [ "SC0352 1:1" ] [ "namespace"; "xmlns" ];
    whole "another element first" (Printf.sprintf "<model %s/>" xmlns) [ "SC0352 1:1" ] [ "<bioshape>" ];
    whole "nothing" (Printf.sprintf "<bioshape %s/>" xmlns) [ "SC0112 1:1" ] [];
    whole "an attribute of the first element"
      (Printf.sprintf "<bioshape %s a='1'><let name='a' value='1'/></bioshape>" xmlns)
      [ "SC0352 1:38" ] [ "`a`" ];
    case "no declaration" "<proces name='p'/>" [ "SC0352 2:1" ] [ "did you mean `process`?" ];
    case "an element of another namespace" "<let xmlns='' name='a' value='1'/>" [ "SC0352 2:1" ] [];
    case "an attribute of another namespace" "<let xmlns:q='r' q:a='1' name='a' value='1'/>"
      [ "SC0352 2:1" ] [ "`a`" ];
    case "an attribute that there is not" "<let name='a' value='1' vlue='2'/>" [ "SC0352 2:25" ] [ "`vlue`" ];
    case "many attributes" ("<let" ^ String.concat "" (List.init 101 (Printf.sprintf " a%d=''")) ^ "/>")
      [ "SC0352 2:1" ] [ "100" ];
    case "text between elements" "<let name='a' value='1'/> x" [ "SC0352 2:27" ] [];
    case "text in an element" "<let name='a' value='1'> y </let>" [ "SC0352 2:26" ] [];
    case "an element in another one" "<let name='a' value='1'><nil/></let>" [ "SC0352 2:25" ] [ "<nil>" ];
    case "after the end of a behaviour" (behaviour "<nil/><nil/>") [ "SC0352 2:27" ] [];
    case "faces before vertices"
      "<shape name='S'><indexedFaceSet><face name='f' vertices='a b c'/><vertex name='a' x='0' y='0' z='0'/>\
       </indexedFaceSet></shape>"
      [ "SC0352 2:66" ] [];
    case "parameters and indices" "<behaviour name='K[1]' parameters='a'><nil/></behaviour>" [ "SC0352 2:1" ] [];
    case "no name" "<process/>" [ "SC0353 2:1"; "SC0353 2:1" ] [ "`name`"; "<leaf>" ];
    case "no value, but nearly" "<let name='a' vlue='1'/>"
      [ "SC0353 2:1"; "SC0352 2:15" ] [ "did you mean `vlue`?" ];
    case "no end of a behaviour" (behaviour "<delay time='1'/>") [ "SC0353 2:1" ] [ "<nil>" ];
    case "a choice of one" (behaviour "<choice><branch><nil/></branch></choice>") [ "SC0353 2:21" ] [];
    case "no behaviour" "<process name='p'><leaf><template name='T'/></leaf></process>" [ "SC0353 2:19" ] [];
    case "no shape" "<process name='p'><leaf><behaviour><nil/></behaviour></leaf></process>" [ "SC0353 2:25" ] [];
    case "a bond without the next leaf"
      "<fixed name='p'><leaf><template name='T'/></leaf><bond channel='a'><feature name='x'/><feature name='y'/>\
       </bond></fixed>"
      [ "SC0353 2:1" ] [];
    case "half a bond" "<bond channel='a'><feature name='x'/></bond>" [ "SC0353 2:1" ] [];
    case "three rows"
      (Printf.sprintf "<fixed name='p'><leaf><template name='T'/><at><matrix>%s</matrix></at></leaf></fixed>"
         (repeated 3 "<row a='1' b='0' c='0' d='0'/>"))
      [ "SC0353 2:47" ] [];
    case "no range" "<for><let name='a' value='1'/></for>" [ "SC0353 2:6" ] [];
    case "no law" "<motion/>" [ "SC0353 2:1" ] [];
    case "half a range of a parameter" "<parameter name='a' from='1'/>" [ "SC0353 2:1" ] [ "`to`" ];
    case "no more than 20" (repeated 30 "<let/>")
      (List.init 20 (fun i -> Printf.sprintf "SC0353 2:%d" (1 + (i / 2 * 6)))) [];
  ]

(* In texts. *)
let texts =
  [
    case "a word for a name" "<process name='nil'><leaf/></process>"
      [ "SC0110 2:16"; "SC0353 2:21"; "SC0353 2:21" ] [];
    case "more than a name" "<let name='a = 1 let b' value='1'/>" [ "SC0110 2:12" ] [ "a name" ];
    case "more than a path" "<motion of='p = inertial motion q'><inertial/></motion>" [ "SC0110 2:13" ] [];
    case "more than a feature"
      (behaviour "<open channel='a'><feature name='x}>. nil + &lt;b, {y'/></open><nil/>") [ "SC0110 2:54" ] [];
    case "two features" (behaviour "<open channel='a'><feature name='x, y'/></open><nil/>") [ "SC0110 2:54" ] [];
    case "only in a name" (behaviour "<open channel='a'><feature name='only y'/></open><nil/>")
      [ "SC0110 2:54" ] [];
    case "more than a call" (behaviour "<call name='A + B'/>") [ "SC0110 2:33" ] [];
    case "definitions with a call" (behaviour "<call name='A where x = 1'/>") [ "SC0110 2:33" ] [];
    case "more than a shape" "<shape name='S'><template name='T scaled (1,1,1)'/></shape>" [ "SC0110 2:33" ] [];
    case "a number as what is rounded" "<round of='velocity 1 +' to='1'/>" [ "SC0110 2:12" ] [];
    case "no text" "<let name='' value=''/>" [ "SC0110 2:12"; "SC0110 2:21" ] [];
    case "a face of no vertices"
      "<shape name='S'><indexedFaceSet><face name='f' vertices=' '/></indexedFaceSet></shape>"
      [ "SC0353 2:58" ] [];
    case "a wrong vertex among others"
      "<shape name='S'><indexedFaceSet><face name='f' vertices='a b- c'/></indexedFaceSet></shape>"
      [ "SC0110 2:60" ] [];
    case "neither true nor false" (behaviour "<open channel='a' co='yes'/><nil/>") [ "SC0110 2:43" ] [ "true" ];
    case "a pace" "<timestep value='1' pace='quick'/>" [ "SC0110 2:27" ] [ "steady" ];
    case "a line end in the name of a file" "<import file='a&#10;b'/>" [ "SC0110 2:15" ] [];
    case "an expression that stops" "<let name='a' value='1 + '/>" [ "SC0110 2:26" ] [ "the text ends here" ];
    case "after a reference" "<let name='a' value='1 &lt; ) 2'/>" [ "SC0110 2:29" ] [ "`)`" ];
    case "a reference itself" "<let name='a' value='1 + &#41; 2'/>" [ "SC0110 2:26" ] [];
    case "in a content" "<check name='a'>\n  always <!-- so -->  <![CDATA[ x(p) <  ]]> or\n</check>"
      [ "SC0110 3:45" ] [];
    case "after letters that are not ASCII" "<!-- \xC3\xA9\xC3\xA9 --><let name='a' value='\xC3\xA9 $'/>"
      [ "SC0104 2:33"; "SC0104 2:35" ] [];
    case "an unknown character" "<let name='a' value='1 $ 2'/>" [ "SC0104 2:24" ] [];
    case "a comment without its end" "<let name='a' value='1 /* 2'/>" [ "SC0105 2:24" ] [];
    case "a comment up to the end" "<let name='a // x' value='1 // 2'/><bond channel='a'/>"
      [ "SC0353 2:36" ] [];
    case "too large" "<let name='a' value='1e1000000000'/>" [ "SC0106 2:22" ] [];
    case "a division by zero" "<let name='a' value='1/0'/>" [ "SC0107 2:24" ] [];
  ]

(* Nothing that XML has no character for can be written. *)
let unwritable () =
  let source =
    Source.make ~name:"m.sc" "import \"a\012b.sc\"\nshape S = mesh \"\xEF\xBF\xBF\" scaled (1, 1, 1)\n"
  in
  match Scc_syntax.Parse.parse source with
  | Error _ -> Alcotest.fail "refused"
  | Ok model -> (
      match Write.model model with
      | Ok text -> Alcotest.fail text
      | Error ds ->
        let place (d : Diag.t) = Printf.sprintf "%s %d" d.code (fst (Source.position source d.span.start)) in
        Alcotest.(check (list string)) "codes" [ "SC0354 1"; "SC0354 2" ] (List.map place ds))

(* What is readable of a document with faults. *)
let readable () =
  let text = around "<let name='a' value='1'/><let/><let name='b' value='2'/><" in
  let items = Read.readable (Source.make ~name:"m.xml" text) in
  Alcotest.(check int) "declarations" 2 (List.length items)

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ("faults of models in XML",
   [
     ("malformed", malformed); ("refused", refused); ("schema", schema); ("texts", texts);
     ("others", [ quick "unwritable" unwritable; quick "readable" readable ]);
   ])
