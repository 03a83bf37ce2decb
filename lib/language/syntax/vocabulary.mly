(* The tokens of the grammar in parser.mly, and how tightly its operators bind. *)

(* Words of the language *)
%token MODEL IMPORT PARAM TIMESTEP SPLIT_STEP DYNAMICS COLLISIONS BINDING BONDS BLOCKED RESOLUTION ROUND SHAPE COMPOUND DECOMPOSE BEHAVIOUR PROCESS FIXED BOND
%token FOR NETWORK MOTION LET CHECK LOCAL STEADY
%token VERTICES FACES SCALED MESH SNAP GRID WELD ORIENT MERGE UNION HULL AS WHERE PART GLUE ON IN MASS VELOCITY SPIN AT
%token TRANSLATE ROTATE QUATERNION SCALE MATRIX
%token ABSORB ONLY NIL OMEGA RHO PUSH EPS INERTIAL CHOOSE WEIGHT
%token TRUE FALSE IF THEN ELSE NOT AND OR FORALL EXISTS COUNT
%token POSSIBLY ALWAYS EVENTUALLY WITHIN LEADS_TO EVENT
%token A E U AG AF AX EG EF EX

(* Marks. LABEL_BRACKET is a `[` whose `]` is followed by a colon: the indices of a leaf's name, where `[`
   would open a behaviour *)
%token LPAREN RPAREN LBRACKET LABEL_BRACKET RBRACKET LBRACE RBRACE
%token COMMA COLON DOT DOTDOT TILDE PARALLEL
%token QUESTION EQ NE LT LE GT GE IMPLIES PLUS MINUS STAR SLASH MOD
%token EOF

%token <string> NAME
(* Letters of the temporal operators that mean nothing alone: X, F, G *)
%token <string> LETTER
%token <string> BARRED
%token <string> STRING
%token <Q.t> NUMBER

(* From the loosest to the tightest; OPEN is for what reaches as far to the right as it can *)
%nonassoc OPEN
%nonassoc LEADS_TO
%nonassoc WITHIN
%right IMPLIES
%left OR
%left AND
%nonassoc NOT
%nonassoc EQ NE LT LE GT GE
%nonassoc WITHIN_ARGUMENT
%nonassoc LBRACKET LABEL_BRACKET
%left PLUS MINUS
%left STAR SLASH MOD
%nonassoc NEGATION

%%
